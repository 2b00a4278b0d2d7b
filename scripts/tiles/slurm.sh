#!/usr/bin/env bash
# Smooths files in tiles under Slurm: a job for plan, then an array of jobs for run, then a job for merge.
# If submitted again, whatever became of the jobs before, only what is missing is done.
# usage: scripts/tiles/slurm.sh folder output_folder jobs file.pcd|ply... [option of plan]...
# jobs is the size N of the array; each job takes every N-th tile. All files must lie on a disk that every node sees.
# The tool is pcl_normal_smoothing_tiles, or TILES_TOOL. Resources of the jobs are set by SBATCH_PLAN, SBATCH_RUN and
# SBATCH_MERGE, for example SBATCH_RUN="--mem=4G --cpus-per-task=2 --time=2:00:00"; give plan the same -memory.
# Prints the numbers of the three jobs.
set -euo pipefail
if [ $# -lt 4 ]; then
  sed -n '2,9s/^# //p' "$0" >&2
  exit 1
fi
tool=$(command -v "${TILES_TOOL:-pcl_normal_smoothing_tiles}")
folder=$(realpath -m "$1") output=$(realpath -m "$2") jobs=$3
shift 3

words () # quoted, so that a shell can read them back
{
  printf '%q ' "$@"
}

# submit NAME OPTIONS COMMAND [option of sbatch]...: prints the number of the job
submit ()
{
  local name=$1 options=$2 command=$3
  shift 3
  # shellcheck disable=SC2086 # the options are words
  sbatch --parsable --job-name "$name" --requeue --kill-on-invalid-dep=yes --output "$folder.%x.%A.%a.log" $options "$@" \
    --wrap "$command"
}

plan=$(submit tiles-plan "${SBATCH_PLAN:-}" "$(words "$tool" plan "$folder" "$@")" --output "$folder.%x.%j.log")
run=$(submit tiles-run "${SBATCH_RUN:-}" \
  "$(words "$tool" run "$folder") -tile \$SLURM_ARRAY_TASK_ID/$jobs -threads \${SLURM_CPUS_PER_TASK:-1}" \
  --dependency "afterok:$plan" --array "0-$((jobs - 1))")
merge=$(submit tiles-merge "${SBATCH_MERGE:-}" "$(words "$tool" merge "$folder" -output_dir "$output")" \
  --dependency "afterok:$run" --output "$folder.%x.%j.log")
echo "$plan $run $merge"
