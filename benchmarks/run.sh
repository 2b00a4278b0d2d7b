#!/usr/bin/env bash
# Installs what is missing, builds, and measures: ratios to the peers with accuracy beside, memory, whole programs, the
# viewer, every stage alone. Nothing else should run meanwhile. doc/performance.md explains the figures.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage="usage: benchmarks/run.sh [-quick] [-large points] [-out folder]

  -quick         a tenth of the points, every time measured once: to see that it works
  -large points  compares the time a point with that of a cloud of so many (default: 32000000, which needs 10 GB; 0: no)
  -out folder    where the tables go (default: benchmark_output)"

points=1000000 repetitions=5 large="" out=$root/benchmark_output stages=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) echo "$usage"; exit 0 ;;
    -quick) points=100000 repetitions=1 large=${large:-0} stages=(--benchmark_min_time=0.01 "--benchmark_filter=points:10000/") ;;
    -large | -out)
      [ $# -gt 1 ] || { echo "benchmarks/run.sh: $1 needs a value" >&2; exit 1; }
      if [ "$1" = -large ]; then large=$2; else out=$2; fi
      shift ;;
    *) echo "$usage" >&2; exit 1 ;;
  esac
  shift
done
large=${large:-32000000}

"$root/evaluation/install_peers.sh" || echo "Not every peer could be installed: its row will say so." >&2
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"
install_packages "libbenchmark-dev|Google Benchmark, for the stages" "python3|the table of the stages"
"$root/scripts/build.sh" -DBUILD_BENCHMARKS=ON -DBUILD_EVALUATION=ON benchmarks/all evaluation/peers/all

mkdir -p "$out"
cd "$out"
bin=$root/build/benchmarks
# Threads that wait must not keep the cores from the peers.
export OMP_WAIT_POLICY=passive
"$bin/ratios" "$points" "$repetitions" "$large" | tee ratios.md
{
  printf '| preset | k | peak bytes a point above input and output |\n|---|---|---|\n'
  for setting in "default 15" "fast 15" "paper 15" "default 32" "fast 16"; do
    # shellcheck disable=SC2086 # two arguments
    "$bin/memory" $setting "$points"
  done
} | tee memory.md
"$bin/programs" 25000 | tee programs.md
if [ -x "$bin/viewer" ]; then
  "$bin/viewer" | tee viewer.md
fi
"$bin/stages" "${stages[@]}" --benchmark_out=stages.json --benchmark_out_format=json >/dev/null
python3 "$root/benchmarks/stage_table.py" stages.json | tee stages.md
echo "The tables: $out"
