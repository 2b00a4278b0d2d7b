#!/usr/bin/env bash
# Installs what is missing and builds into build/, optimised.
# usage: scripts/build.sh [-Dname=value]... [target]...        default: everything, tests included
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

settings=()
while [[ ${1:-} == -D* ]]; do
  settings+=("$1")
  shift
done
"$root/scripts/install_dependencies.sh"
cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DWARNINGS_AS_ERRORS="${WARNINGS_AS_ERRORS:-OFF}" "${settings[@]}"
cmake --build "$root/build" --parallel "$(nproc)" --target "${@:-all}"
