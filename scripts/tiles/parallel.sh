#!/usr/bin/env bash
# Smooths files in tiles on this machine, several at once by GNU parallel. If run again, it continues where it stopped.
# usage: scripts/tiles/parallel.sh folder output_folder jobs file.pcd|ply... [option of plan]...
# The tool is pcl_normal_smoothing_tiles, or TILES_TOOL. A job has one thread, or TILES_THREADS; -memory is per job.
set -euo pipefail
if [ $# -lt 4 ]; then
  sed -n '2,4s/^# //p' "$0" >&2
  exit 1
fi
tool=${TILES_TOOL:-pcl_normal_smoothing_tiles}
folder=$1 output=$2 jobs=$3
shift 3

"$tool" plan "$folder" "$@"
# A tile that fails is tried once more; the exit status reports those that fail again.
"$tool" list "$folder" |
  parallel --will-cite --jobs "$jobs" --retries 2 "$tool" run "$folder" -tile {} -threads "${TILES_THREADS:-1}"
"$tool" merge "$folder" -output_dir "$output"
