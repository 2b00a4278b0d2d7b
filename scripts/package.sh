#!/usr/bin/env bash
# Makes the Debian packages: library, -dev and tools, in packages/.
# usage: scripts/package.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build_package
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"

"$root/scripts/install_dependencies.sh"
install_packages \
  "dpkg-dev|the dependencies of the packages" \
  "file|tells programs from other files" \
  "lintian|checks the packages"
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
umask 022

# In Debian's folders, libraries are found without an RPATH.
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DCMAKE_SKIP_INSTALL_RPATH=ON -DBUILD_TESTING=OFF -DBUILD_EXAMPLES=OFF
cmake --build "$build" --parallel "${JOBS:-$(nproc)}"
rm -rf "$root/packages"
(cd "$build" && cpack -B "$root/packages")
rm -rf "$root/packages/_CPack_Packages"
lintian --fail-on error "$root"/packages/*.deb
ls -l "$root"/packages/*.deb
