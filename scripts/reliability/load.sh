#!/usr/bin/env bash
# Tests many clouds, many processes, many points.
# usage: scripts/reliability/load.sh [points] [build directory]      default 32000000; 0 leaves the large cloud out
# Exit status 1 if a promise of doc/reliability.md does not hold.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "${2:-$root/build}" && pwd)
points=${1:-32000000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"
install_packages "time|the memory that a process takes"
export OMP_WAIT_POLICY=passive
status=0

processes_at_once ()
{
  local i pids=() wrong=0
  "$build/tools/pcl_make_double_torus" mesh.ply >/dev/null
  "$build/tools/pcl_add_surface_noise" mesh.ply cloud.pcd >/dev/null
  "$build/tools/pcl_normal_smoothing" cloud.pcd expected.pcd -preset fast >/dev/null
  for ((i = 0; i < 100; ++i)); do # every other process writes the same file
    "$build/tools/pcl_normal_smoothing" cloud.pcd "out_$((i % 2 * i)).pcd" -preset fast -threads 1 >/dev/null &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do
    wait "$pid" || wrong=$((wrong + 1))
  done
  for file in out_*.pcd; do
    cmp -s "$file" expected.pcd || wrong=$((wrong + 1))
  done
  [ "$(ls out_*.pcd | wc -l)" -eq 51 ] && [ "$(ls | wc -l)" -eq 54 ] || wrong=$((wrong + 1))
  echo "100 processes in one folder: $wrong wrong"
  [ $wrong -eq 0 ]
}

large_cloud ()
{
  local start
  "$build/test/reliability/large_cloud" large.pcd "$points"
  start=$SECONDS
  /usr/bin/time -f 'at most %M kB of memory' "$build/tools/pcl_normal_smoothing" large.pcd smoothed.pcd -preset fast
  local ended=$?
  echo "$points points: status $ended, $((SECONDS - start)) s, $(stat -c %s smoothed.pcd) bytes"
  [ $ended -eq 0 ] && [ "$(stat -c %s smoothed.pcd)" -ge $((points * 12)) ]
}

"$build/test/reliability/soak" 1000 || status=1
processes_at_once || status=1
[ "$points" -eq 0 ] || large_cloud || status=1
exit $status
