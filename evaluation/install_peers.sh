#!/usr/bin/env bash
# Installs from Debian's packages the other methods of the study, and what they need, as far as this machine lacks them.
# Each is optional: the study marks the rows of an absent one and goes on. CGAL's and PCL's methods, and LOP, are in the
# program pcl_smoothing_peer of the build.
set -euo pipefail
# shellcheck source=scripts/debian_packages.sh
. "$(dirname "${BASH_SOURCE[0]}")/../scripts/debian_packages.sh"

install_packages \
  "libcgal-dev|WLOP, jet and bilateral smoothing" \
  "libtbb-dev|the same on all cores" \
  "libpcl-dev|PCL's moving least squares" \
  "meshlab|APSS and RIMLS" \
  "xvfb|the display that MeshLab does not start without" \
  "xauth|the key to that display"
