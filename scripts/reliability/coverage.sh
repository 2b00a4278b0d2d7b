#!/usr/bin/env bash
# Reports which lines of include, src and tools are run by the tests. Exit status 1 below 95 %.
# usage: scripts/reliability/coverage.sh      the report: build_coverage/coverage.html
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"
build=$root/build_coverage

"$root/scripts/install_dependencies.sh"
install_packages "gcovr|counts the lines that ran"
cmake -S "$root" --preset coverage
cmake --build "$build" --parallel "$(nproc)"
find "$build" -name '*.gcda' -delete
OMP_WAIT_POLICY=passive ctest --test-dir "$build" --output-on-failure --no-tests=error \
  --exclude-regex 'package|consumer|readme|hostile_files|soak|faults'
# A line of a kernel counts if one instruction set ran it: others are for other machines.
gcovr --root "$root" --object-directory "$build" --filter "$root/include/" --filter "$root/src/" --filter "$root/tools/" \
  --exclude-throw-branches --gcov-ignore-parse-errors -j "$(nproc)" \
  --html-details "$build/coverage.html" --txt "$build/coverage.txt" --print-summary --fail-under-line 95
