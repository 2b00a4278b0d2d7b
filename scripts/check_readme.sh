#!/usr/bin/env bash
# Runs the commands of README.md for building, packaging and installing literally, in a fresh copy of the sources, and
# removes what they installed. The other commands of the README are run by the tests.
# usage: scripts/check_readme.sh        as root: it installs packages
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

git -C "$root" archive --prefix=sources/ HEAD | tar -x -C "$work"
cd "$work/sources"
mkdir "$work/home"
# commands <heading>: prints the commands of the section of that name
commands () { awk -v heading="## $1" '/^## / { here = $0 == heading } /^```/ { on = here && /^```sh/; next } on' README.md |
  sed -E 's/ +#.*//'; }

echo "== Build by hand"
commands "Build by hand" | HOME=$work/home bash -eux
"$work/home/.local/bin/pcl_normal_smoothing" -h >/dev/null

echo "== Install"
commands Install | grep '^scripts/package.sh' | sed 's/apt install/apt-get install -y --no-install-recommends/' | bash -eux
cd "$work"
/usr/bin/pcl_make_double_torus torus.ply
/usr/bin/pcl_normal_smoothing torus.ply smoothed.ply
man -w pcl_normal_smoothing
apt-get remove -y -q 'libpcl-normal-smoothing*' pcl-normal-smoothing-tools
echo "What README.md says of building and installing works."
