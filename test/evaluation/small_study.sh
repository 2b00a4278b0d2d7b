#!/usr/bin/env bash
# The small study as a user runs it, from the mesh to the page: ends well, names the page, and it is there.
# usage: small_study.sh <study.sh> <build folder> <folder for the results>
# SPDX-License-Identifier: BSD-3-Clause
set -euo pipefail
study=$1 built=$2 out=$3
rm -rf "$out/report" # an earlier one
"$study" -small -built "$built" -out "$out" | tee "$out.log"
grep -qxF "The report: $out/report/index.html" "$out.log"
test -s "$out/report/index.html"
