#!/usr/bin/env bash
# Runs slurm.sh under a real Slurm on this machine (Debian's slurmctld and slurmd, 16 slots, munge with its own key) and
# parallel.sh; leaves nothing behind. As root. Exit status 1 if a tile is lost, or the result is not the whole cloud's.
# usage: scripts/tiles/test_slurm.sh [folder of the tools] [points]      default: build/tools, 200000
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tools=$(cd "${1:-$root/build/tools}" && pwd) || exit 1
points=${2:-200000}
# shellcheck source=scripts/debian_packages.sh
. "$root/scripts/debian_packages.sh"
install_packages "slurmctld|the controller of Slurm" "slurmd|runs its jobs" "slurm-client|submits them" \
  "munge|by which they trust each other" "parallel|GNU parallel" || exit 1

folder=$(mktemp -d)
chmod 755 "$folder"
pids=()
failures=0
end ()
{
  scancel --user root 2>/dev/null
  sleep 1
  kill "${pids[@]}" 2>/dev/null
  wait "${pids[@]}" 2>/dev/null
  rm -rf "$folder"
}
trap end EXIT
cd "$folder" || exit 1
export OMP_WAIT_POLICY=passive TILES_TOOL=$tools/pcl_normal_smoothing_tiles SLURM_CONF=$folder/slurm.conf

check () # NAME COMMAND...
{
  local name=$1
  shift
  if "$@"; then echo "ok   $name"; else echo "FAIL $name"; failures=$((failures + 1)); fi
}

start_slurm ()
{
  mkdir -p munge state spool
  head -c 1024 /dev/urandom >munge/key
  chmod 700 munge
  chmod 600 munge/key
  mkdir -m 755 socket
  /usr/sbin/munged --foreground --force --key-file "$folder/munge/key" --socket "$folder/socket/munge" \
    --pid-file "$folder/munge/pid" --log-file "$folder/munge/log" --seed-file "$folder/munge/seed" >/dev/null 2>&1 &
  pids+=($!)
  cat >slurm.conf <<EOF
ClusterName=tiles
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
AuthInfo=socket=$folder/socket/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SlurmdParameters=config_overrides
SlurmdTimeout=10
VSizeFactor=100
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=batch_sched_delay=1,sched_interval=2
ReturnToService=2
DefMemPerCPU=4000
MailProg=/bin/true
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=16 RealMemory=64000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
  for _ in $(seq 50); do [ -S socket/munge ] && break || sleep 0.1; done
  slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
  pids+=($!)
  sleep 2
  start_node
}

start_node ()
{
  slurmd -D -f "$SLURM_CONF" >/dev/null 2>&1 &
  slurmd=$!
  pids+=($slurmd)
  for _ in $(seq 120); do sinfo --noheader --format %t 2>/dev/null | grep -q idle && return 0 || sleep 1; done
  cat slurmctld.log slurmd.log >&2
  return 1
}

wait_for_jobs ()
{
  for _ in $(seq 900); do
    [ -z "$(squeue --noheader 2>/dev/null)" ] && return 0
    sleep 1
  done
  return 1
}

submit () # FOLDER [largest tile]
{
  "$root/scripts/tiles/slurm.sh" "$1" "$1.out" 8 cloud.pcd -max_points "${2:-$((points / 20))}" -preset fast
}

# Prints the id of the process that runs a tile of a plan, as soon as there is one.
running_job () # FOLDER
{
  for _ in $(seq 600); do
    pgrep -f "pcl_normal_smoothing_tiles run $folder/$1" | head -1 | grep . && return 0
    sleep 0.05
  done
  return 1
}

# Kills the processes that slurmd has started for jobs. They are not its children; what tells them from those of another
# Slurm is that they have its log open, from their first moments on.
kill_steps ()
{
  for _ in $(seq 10); do
    for step in $(pgrep -x slurmstepd); do
      find "/proc/$step/fd" -lname "$folder/*" 2>/dev/null | grep -q . && kill -9 "$step"
    done
    sleep 0.1
  done
}

# Prints the files of results that are newer than the file "before".
changed_results ()
{
  for result in tiles.d/*.result; do
    [ "$result" -nt before ] && echo "$result"
  done
}

start_slurm || { echo "FAIL Slurm does not start"; exit 1; }
sinfo --Node --long
"$tools/../test/reliability/large_cloud" cloud.pcd "$points"
"$tools/pcl_normal_smoothing" cloud.pcd whole.pcd -preset fast >/dev/null || exit 1

echo "jobs $(submit tiles.d)"
check "the jobs end" wait_for_jobs
check "all tiles, to the byte" cmp whole.pcd tiles.d.out/cloud.pcd
tiles=$(ls tiles.d/*.result | wc -l)
echo "     $tiles tiles"

touch before
sleep 1.1
submit tiles.d >/dev/null
wait_for_jobs
check "submitted again, no tile is run again" [ -z "$(changed_results)" ]

# One tile is lost, one damaged, and a job is killed while it runs.
rm tiles.d/tile_000003.result
printf x | dd of=tiles.d/tile_000005.result bs=1 seek=1000 conv=notrunc status=none
rm -rf tiles.d.out
touch before
sleep 1.1
submit tiles.d >/dev/null
wait_for_jobs
check "only the lost and the damaged tile are run again" \
  [ "$(changed_results | tr '\n' ' ')" = "tiles.d/tile_000003.result tiles.d/tile_000005.result " ]
check "to the byte" cmp whole.pcd tiles.d.out/cloud.pcd

submit killed.d >/dev/null
victim=$(running_job killed.d)
kill -9 "$victim" 2>/dev/null
wait_for_jobs
check "a job that was killed leaves no output" [ ! -e killed.d.out/cloud.pcd ]
check "and some tiles to do" [ "$("$TILES_TOOL" list killed.d | wc -l)" -gt 0 ]
submit killed.d >/dev/null
wait_for_jobs
check "the same command completes it" cmp whole.pcd killed.d.out/cloud.pcd

# A node loses power, with everything that runs on it, and comes back: its jobs are put back into the queue.
submit lost.d >/dev/null
running_job lost.d >/dev/null
kill -9 "$slurmd"
kill_steps
pkill -9 -f "pcl_normal_smoothing_tiles run $folder/lost.d"
for _ in $(seq 120); do sinfo --noheader --format %t | grep -q down && break || sleep 1; done
check "the controller sees that the node is lost" grep -q down <(sinfo --noheader --format %t)
check "no output yet" [ ! -e lost.d.out/cloud.pcd ]
start_node
wait_for_jobs
check "the node is back: its jobs run again, to the byte" cmp whole.pcd lost.d.out/cloud.pcd

# Tiles that need more memory than their jobs may have; given more, the jobs continue where they were.
large=$((points * 5))
"$tools/../test/reliability/large_cloud" large.pcd "$large"
"$tools/pcl_normal_smoothing" large.pcd whole_large.pcd -preset fast >/dev/null || exit 1
large_job () { "$root/scripts/tiles/slurm.sh" large.d large.out 4 large.pcd -max_points "$large" -preset fast >/dev/null; }
SBATCH_RUN="--mem=110" large_job
wait_for_jobs
check "a job that runs out of memory says so" grep -q "not enough memory" large.d.tiles-run.*.log
check "and leaves no output" [ ! -e large.out/large.pcd ]
large_job
wait_for_jobs
check "with more memory the same command completes it" cmp whole_large.pcd large.out/large.pcd

check "GNU parallel" "$root/scripts/tiles/parallel.sh" parallel.d parallel.out 4 cloud.pcd -max_points $((points / 10)) -preset fast
check "to the byte" cmp whole.pcd parallel.out/cloud.pcd
[ $failures -eq 0 ]
