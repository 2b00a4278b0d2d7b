#!/usr/bin/env bash
# Builds the ROS 1 nodelet (ros/) with Debian's ROS and runs it: a published cloud must come back smoothed, with all its
# fields, its frame and its stamp. Debian has no ROS 2: the ROS 2 code in doc/ros.md is only compiled, with the messages
# and conversions of ROS 1, which have the same members.
# usage: scripts/check_ros.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build_ros
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"

"$root/scripts/install_dependencies.sh"
install_packages \
  "ros-core|ROS 1" \
  "python3-roslaunch|roslaunch" \
  "catkin|its build system" \
  "libpcl-ros-dev|the filters of pcl_ros" \
  "libnodelet-dev|nodelets" \
  "libnodeletlib-tools|the program that runs them" \
  "python3-dynamic-reconfigure|parameters that change while it runs" \
  "python3-sensor-msgs|the messages of the test" \
  "python3-numpy|its clouds" \
  "pkg-config|the flags of a node of ROS 2"

export PATH=/usr/bin:$PATH # Debian's Python, for which its ROS is made
cmake -S "$root" -B "$build/library" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DBUILD_TOOLS=OFF \
  -DBUILD_EXAMPLES=OFF -DCMAKE_INSTALL_PREFIX="$build/install"
cmake --build "$build/library" --parallel "$(nproc)" --target install
cmake -S "$root/ros" -B "$build/nodelet" -G Ninja -DCMAKE_PREFIX_PATH="$build/install" \
  -DCMAKE_INSTALL_PREFIX="$build/install" -DCMAKE_INSTALL_RPATH="$build/install/lib" -DCATKIN_BUILD_BINARY_PACKAGE=ON
cmake --build "$build/nodelet" --parallel "$(nproc)" --target install

{
  printf '#include <sensor_msgs/PointCloud2.h>\nnamespace sensor_msgs::msg { using sensor_msgs::PointCloud2; }\n'
  snippet=$(awk '/^## / { here = /ROS 2/ } /^```/ { on = here && /^```cpp/; next } on' "$root/doc/ros.md")
  grep '^#include' <<<"$snippet"
  printf 'struct Publisher { void publish (const sensor_msgs::msg::PointCloud2&) {} };\nstruct Node {\n'
  grep -v '^#include' <<<"$snippet"
  printf 'pcl_normal_smoothing::NormalSmoothing<pcl::PCLPointCloud2> smoothing_;\nPublisher* publisher_;\n};\n'
} >"$build/ros2_node.cpp"
flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$build/install" -name pcl_normal_smoothing.pc)") pkg-config --cflags pcl_normal_smoothing)
# shellcheck disable=SC2086
g++ -std=c++17 -fsyntax-only $flags "$build/ros2_node.cpp"
echo "What doc/ros.md says of ROS 2 compiles."

export ROS_MASTER_URI=http://localhost:${ROS_PORT:-11399} ROS_LOG_DIR=$build/log ROS_HOSTNAME=localhost
export ROS_PACKAGE_PATH=$build/install/share:/usr/share CMAKE_PREFIX_PATH=$build/install:/usr
export LD_LIBRARY_PATH=$build/install/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export PYTHONPATH=$build/install/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH} PYTHONDONTWRITEBYTECODE=1
roslaunch -p "${ROS_PORT:-11399}" pcl_normal_smoothing_ros normal_smoothing.launch input:=/cloud &
roslaunch=$!
trap 'kill $roslaunch 2>/dev/null; wait $roslaunch || true' EXIT
timeout 120 /usr/bin/python3 "$root/ros/test/test_nodelet.py"
echo "The nodelet smooths."
