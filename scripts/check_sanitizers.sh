#!/usr/bin/env bash
# Installs what is missing, builds under sanitizers and runs the tests: all of them under AddressSanitizer and
# UndefinedBehaviorSanitizer, those of the library under ThreadSanitizer.
# usage: scripts/check_sanitizers.sh [asan-ubsan|tsan]...      default: both
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"
[ $# -gt 0 ] || set -- asan-ubsan tsan

export OMP_WAIT_POLICY=passive
# VTK and CGAL never free some objects; a damaged file that claims too much memory must get std::bad_alloc.
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1
export LSAN_OPTIONS=suppressions=$root/scripts/reliability/lsan.supp:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 suppressions=$root/scripts/reliability/tsan.supp"
# Archer, which comes with libomp, informs ThreadSanitizer about OpenMP's barriers and locks.
export OMP_TOOL_LIBRARIES=/usr/lib/llvm-14/lib/libarcher.so

"$root/scripts/install_dependencies.sh"
for preset in "$@"; do
  case $preset in
    asan-ubsan) ;;
    tsan) install_packages "clang|the compiler" "libomp-14-dev|its OpenMP" "libclang-rt-14-dev|its sanitizers" ;;
    *)
      echo "scripts/check_sanitizers.sh: no sanitizer is called $preset: give asan-ubsan or tsan" >&2
      exit 1 ;;
  esac
  cmake -S "$root" --preset "$preset"
  cmake --build "$root/build_$preset" --parallel "$(nproc)"
  # A consumer of the package and the graphics driver are built without sanitizers; tests that limit their memory leave
  # no room for shadow memory.
  ctest --test-dir "$root/build_$preset" --output-on-failure --no-tests=error --parallel "$(nproc)" \
    --exclude-regex 'package|consumer|readme|test_viewer|hostile_files|soak|faults'
done
