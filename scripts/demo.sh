#!/usr/bin/env bash
# Installs what is missing, builds, and smooths a cloud.
# usage: scripts/demo.sh [cloud.pcd|cloud.ply]
# Without a cloud it makes a noisy double torus, smooths it and says how far both are from the true surface.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/demo_output
tools=$root/build/tools

smooth_cloud ()
{
  local cloud=$1 name
  name=$(basename "$cloud")
  local smoothed="$out/${name%.*}_smoothed.${name##*.}"
  "$tools/pcl_normal_smoothing" "$cloud" "$smoothed"
  printf '\nsmoothed: %s\n' "$smoothed"
}

p2s_mean ()
{
  "$tools/pcl_smoothing_error" "$out/double_torus.ply" "$1" -json 1 |
    grep -o '"p2s_mean" *: *[-+.0-9e]*' | sed 's/.*: *//'
}

smooth_double_torus ()
{
  local noisy=$out/double_torus_noisy.ply smoothed=$out/double_torus_smoothed.ply before after
  "$tools/pcl_make_double_torus" "$out/double_torus.ply"
  "$tools/pcl_add_surface_noise" "$out/double_torus.ply" "$noisy" -type GN -sigma 0.2 -seed 1
  "$tools/pcl_normal_smoothing" "$noisy" "$smoothed"
  before=$(p2s_mean "$noisy")
  after=$(p2s_mean "$smoothed")
  printf '\nmean distance to the true surface (p2s): %s before, %s after smoothing\n' "$before" "$after"
  printf 'noisy:    %s\nsmoothed: %s\n' "$noisy" "$smoothed"
}

usage="usage: scripts/demo.sh [cloud.pcd|cloud.ply]"
case "$#:${1:-}" in
  1:-h | 1:--help)
    echo "$usage"
    exit 0 ;;
  1:-* | [2-9]*)
    echo "$usage" >&2
    exit 1 ;;
esac
if [ $# -eq 1 ] && [ ! -r "$1" ]; then
  echo "scripts/demo.sh: cannot read $1: give it a PCD or PLY file" >&2
  exit 2
fi

"$root/scripts/build.sh" tools/all
mkdir -p "$out"
if [ $# -eq 1 ]; then
  smooth_cloud "$1"
else
  smooth_double_torus
fi
