#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test, including those of the study in evaluation/.
# usage: scripts/test.sh [ctest option]...        for example -R smoothing
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/evaluation/install_report.sh"
"$root/evaluation/install_peers.sh" || echo "Not every peer could be installed: their tests are skipped." >&2
"$root/scripts/build.sh" -DBUILD_EVALUATION=ON
ctest --test-dir "$root/build" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
