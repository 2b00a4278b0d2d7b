#!/usr/bin/env bash
# Installs from Debian's packages what the study's own program and its report need and this machine lacks.
# The other methods have their own: install_peers.sh.
set -euo pipefail
# shellcheck source=scripts/debian_packages.sh
. "$(dirname "${BASH_SOURCE[0]}")/../scripts/debian_packages.sh"

install_packages \
  "nlohmann-json3-dev|the study's rows as JSON" \
  "python3-matplotlib|the plots" \
  "python3-numpy|arrays" \
  "python3-pil|pictures inside the page" \
  "python3-scipy|nearest neighbours, for surface variation" \
  "python3-vtk9|the renderings" \
  "xvfb|a display for them" \
  "libgl1-mesa-dri|drawing without a graphics card"
