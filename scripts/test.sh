#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test.
# usage: scripts/test.sh [ctest option]...        for example -R smoothing
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/build.sh"
ctest --test-dir "$root/build" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
