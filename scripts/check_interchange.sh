#!/usr/bin/env bash
# What the tools write must open in CloudCompare, MeshLab and Open3D (Debian's packages), and each tool must read what
# they write. Prints one line per case, which doc/interchange.md repeats.
# usage: scripts/check_interchange.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"

install_packages \
  "cloudcompare|CloudCompare" \
  "meshlab|MeshLab, meshlabserver" \
  "python3-open3d|Open3D" \
  "python3-numpy|the clouds" \
  "xvfb|a display for them" \
  "xauth|it" \
  "libgl1-mesa-dri|drawing without a graphics card"
"$root/scripts/build.sh" tools/all
PYTHONDONTWRITEBYTECODE=1 OMP_WAIT_POLICY=passive xvfb-run -a /usr/bin/python3 "$root/scripts/interchange/interchange.py" \
  "$root/build/tools"
