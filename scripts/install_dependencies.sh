#!/usr/bin/env bash
# Installs from Debian's packages what the build needs and this machine lacks. Does nothing, and needs no network, if
# nothing is missing.
set -euo pipefail
# shellcheck source=scripts/debian_packages.sh
. "$(dirname "${BASH_SOURCE[0]}")/debian_packages.sh"

install_packages \
  "g++|the C++17 compiler" \
  "cmake|configures the build" \
  "ninja-build|runs the build" \
  "ccache|makes a second build fast" \
  "libpcl-dev|the Point Cloud Library, 1.12 or newer, with Eigen, FLANN, Boost and VTK" \
  "libcgal-dev|CGAL, which reads meshes in the tools" \
  "nlohmann-json3-dev|the reports of the tools" \
  "libxxhash-dev|checksums of tiles" \
  "liblzf-dev|compressed PCD files" \
  "doxygen|the reference of the classes, and its test" \
  "help2man|man pages, and their test" \
  "libgtest-dev|GoogleTest, for the tests"
