#!/usr/bin/env bash
# Smooths files in tiles on this machine, several tiles at once by GNU parallel. Run again, it goes on where it was interrupted.
# usage: scripts/tiles/parallel.sh folder output_folder jobs file.pcd|ply... [option of plan]...
# The tool is pcl_normal_smoothing_tiles, or what TILES_TOOL says. A job has one thread, or TILES_THREADS; -memory is for a job.
set -euo pipefail
if [ $# -lt 4 ]; then
  sed -n '2,4s/^# //p' "$0" >&2
  exit 1
fi
tool=${TILES_TOOL:-pcl_normal_smoothing_tiles}
folder=$1 output=$2 jobs=$3
shift 3

"$tool" plan "$folder" "$@"
# What failed is tried once more; the exit status tells of what fails again.
"$tool" list "$folder" |
  parallel --will-cite --jobs "$jobs" --retries 2 "$tool" run "$folder" -tile {} -threads "${TILES_THREADS:-1}"
"$tool" merge "$folder" -output_dir "$output"
