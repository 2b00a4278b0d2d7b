#!/usr/bin/env bash
# Builds the package (package.xml, plain cmake) in a colcon workspace with Debian's colcon, and a program that uses it.
# usage: scripts/check_colcon.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
workspace=$root/build_colcon
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"

"$root/scripts/install_dependencies.sh"
install_packages \
  "colcon|builds a ROS workspace" \
  "python3-colcon-cmake|its packages of plain cmake" \
  "python3-colcon-ros|package.xml" \
  "python3-colcon-bash|setup.bash" \
  "python3-colcon-library-path|libraries in it"

rm -rf "$workspace"
mkdir -p "$workspace/src/consumer"
ln -s "$root" "$workspace/src/pcl_normal_smoothing"
cp "$root/test/package/consumer/CMakeLists.txt" "$root/examples/smooth_cloud.cpp" "$workspace/src/consumer"
# A package that depends on this one by its package.xml, and finds it with find_package.
cat >"$workspace/src/consumer/package.xml" <<'END'
<package format="3">
  <name>smooth_cloud</name>
  <version>0.0.0</version>
  <description>A consumer</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>BSD-3-Clause</license>
  <buildtool_depend>cmake</buildtool_depend>
  <depend>pcl_normal_smoothing</depend>
  <export><build_type>cmake</build_type></export>
</package>
END
echo 'install(TARGETS smooth_cloud)' >>"$workspace/src/consumer/CMakeLists.txt"

cd "$workspace"
export PATH=/usr/bin:$PATH # Debian's Python, for which its colcon is made
colcon build --executor sequential \
  --cmake-args -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DBUILD_EXAMPLES=OFF
set +u
# shellcheck disable=SC1091
. install/setup.bash
set -u
smooth_cloud
pcl_normal_smoothing -h >/dev/null
ldd "$(command -v smooth_cloud)" | grep -q "$workspace/install/pcl_normal_smoothing/"
test -f install/pcl_normal_smoothing/share/pcl_normal_smoothing/package.xml
echo "colcon builds pcl_normal_smoothing, and what depends on it."
