#!/usr/bin/env bash
# Installs from Debian's packages what the build needs and this machine lacks. Does nothing, and needs no network, where
# everything is there.
# usage: scripts/install_dependencies.sh [package]...      with packages: those too, which only some scripts need
set -euo pipefail

# package | what it is for
needed=(
  "g++|the C++17 compiler"
  "cmake|configures the build"
  "ninja-build|runs the build"
  "ccache|makes a second build fast"
  "libpcl-dev|the Point Cloud Library, 1.12 or newer, with Eigen, FLANN, Boost and VTK"
  "libcgal-dev|CGAL, which reads meshes in the tools"
  "libgtest-dev|GoogleTest, for the tests"
)
for package in "$@"; do
  needed+=("$package|asked for")
done

installed ()
{
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root ()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "Cannot install packages: run this as root, or install sudo." >&2
    return 1
  fi
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "Not a Debian system: nothing is installed here. What is needed, under Debian's names:" >&2
  printf '  %s\n' "${needed[@]/|/: }" >&2
  exit 0
fi

missing=()
for line in "${needed[@]}"; do
  package=${line%%|*}
  if ! installed "$package"; then
    [ ${#missing[@]} -gt 0 ] || echo "Installing what is missing from Debian's packages:"
    echo "  $package: ${line#*|}"
    missing+=("$package")
  fi
done

if [ ${#missing[@]} -gt 0 ]; then
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
fi
