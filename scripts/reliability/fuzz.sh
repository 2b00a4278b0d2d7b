#!/usr/bin/env bash
# Fuzzes how the tools load clouds and meshes, one format after the other, starting from the corpus in fuzz/corpus.
# usage: scripts/reliability/fuzz.sh [seconds per format]      default 300
# Findings are written to build_fuzz/; exit status 1 if there are any.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"
seconds=${1:-300}
build=$root/build_fuzz

"$root/scripts/install_dependencies.sh"
install_packages "clang|the compiler" "libomp-14-dev|its OpenMP" "libclang-rt-14-dev|its sanitizers"
cmake -S "$root" --preset fuzz
cmake --build "$build" --parallel "$(nproc)" --target fuzz/all

status=0
# The targets define their own operator new, which other libraries' allocations bypass.
export ASAN_OPTIONS=alloc_dealloc_mismatch=0
for target in cloud_pcd cloud_ply mesh_off mesh_obj mesh_ply mesh_stl; do
  mkdir -p "$build/found_$target"
  "$build/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 \
    -artifact_prefix="$build/$target." "$build/found_$target" "$root/fuzz/corpus/${target#*_}" 2>&1 |
    grep -E "^(Done|==|SUMMARY|artifact)|ERROR|runtime error|DONE" || status=1
done
if ls "$build"/*.crash-* "$build"/*.oom-* "$build"/*.timeout-* >/dev/null 2>&1; then
  ls "$build"/*.crash-* "$build"/*.oom-* "$build"/*.timeout-* 2>/dev/null
  status=1
fi
exit $status
