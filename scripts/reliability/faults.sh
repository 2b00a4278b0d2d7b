#!/usr/bin/env bash
# Tests what may befall a running tool: it is killed, the disk is full, it lacks rights or memory, a file vanishes.
# usage: scripts/reliability/faults.sh [folder of the tools] [kills]      default: build/tools, 200 kills
# Exit status 1 if a promise of doc/reliability.md does not hold.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tools=$(cd "${1:-$root/build/tools}" && pwd)
kills=${2:-200}
smooth=$tools/pcl_normal_smoothing
folder=$(mktemp -d)
disk=
failures=0
trap 'umount "$disk" 2>/dev/null; chmod -R u+rwx "$folder"; rm -rf "$folder"' EXIT
cd "$folder" || exit 1

report ()
{
  printf '%-4s %s\n' "$1" "$2"
  [ "$1" != FAIL ] || failures=$((failures + 1))
}

# check NAME CONDITION...: a test command
check ()
{
  local name=$1
  shift
  if "$@"; then report ok "$name"; else report FAIL "$name: $(head -c 300 err 2>/dev/null)"; fi
}

# as_before: checks that there are the same files as before, with the same content
as_before ()
{
  [ "$(checksums)" = "$before" ]
}

checksums ()
{
  find . -type f ! -name err ! -name out -exec md5sum {} + | sort -k 2
}

# run STATUS COMMAND...: the command must end with that status
run ()
{
  local expected=$1 status
  shift
  "$@" >out 2>err
  status=$?
  [ $status -eq "$expected" ] || { echo "status $status, not $expected" >>err; return 1; }
}

says ()
{
  grep -q -- "$1" err
}

# A cloud of 4,350 points, and one that takes a while to write.
make_clouds ()
{
  "$tools/pcl_make_double_torus" mesh.ply >/dev/null
  "$tools/pcl_add_surface_noise" mesh.ply cloud.pcd >/dev/null
  "$smooth" cloud.pcd complete.pcd -preset fast -format ascii >/dev/null
  awk 'BEGIN {
    print "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 60000\nHEIGHT 1\nPOINTS 60000\nDATA ascii"
    srand (1)
    for (i = 0; i < 60000; ++i)
      printf "%.7g %.7g %.7g\n", i % 245 / 100, int (i / 245) / 100, sin (i % 245 / 50) + 0.005 * rand ()
  }' >large.pcd
  "$smooth" large.pcd large_complete.pcd -preset fast -format ascii >/dev/null
}

# seconds FROM TO: a random number
seconds ()
{
  awk -v seed=$RANDOM -v a="$1" -v b="$2" 'BEGIN {srand (seed); print a + (b - a) * rand ()}'
}

# The tool is killed at random moments, two times in three while it writes: the output is the old file or the new one.
killed ()
{
  local i pid wrong=0 old=0 new=0 writing=0
  for ((i = 0; i < kills; ++i)); do
    echo precious >target.pcd
    "$smooth" large.pcd target.pcd -preset fast -format ascii >/dev/null 2>&1 &
    pid=$!
    if [ $((i % 3)) -eq 0 ]; then
      sleep "$(seconds 0 "$duration")"
    else
      until compgen -G 'target.??????.pcd' >/dev/null || ! kill -0 $pid 2>/dev/null; do :; done
      sleep "$(seconds 0 0.04)"
    fi
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
    compgen -G 'target.??????.pcd' >/dev/null && writing=$((writing + 1))
    if cmp -s target.pcd large_complete.pcd; then
      new=$((new + 1))
    elif [ "$(cat target.pcd)" = precious ]; then
      old=$((old + 1))
    else
      wrong=$((wrong + 1))
    fi
    rm -f target.??????.pcd
  done
  check "killed $kills times, $writing while it wrote: $old times the old file, $new times the new one" [ $wrong -eq 0 ]
  rm -f target.pcd
}

interrupted ()
{
  local signal status
  for signal in INT:130 TERM:143; do
    # A shell starts background processes with SIGINT ignored; setsid does not undo that, env does.
    env --default-signal=INT "$smooth" cloud.pcd target.pcd -update paper -point_iterations 1000000 >out 2>err &
    sleep 0.7
    kill "-${signal%:*}" $!
    wait $!
    status=$?
    check "SIG${signal%:*}: status ${signal#*:}" [ $status -eq "${signal#*:}" ]
    check "SIG${signal%:*}: nothing is left behind" as_before
  done
}

# A disk of 64 kB.
full_disk ()
{
  disk=$folder/disk
  mkdir "$disk"
  if ! mount -t tmpfs -o size=64k tmpfs "$disk" 2>/dev/null; then
    report skip "a full disk: this user may not mount a tmpfs"
    disk=
    return
  fi
  echo precious >"$disk/target.pcd"
  check "a full disk: status 2" run 2 "$smooth" cloud.pcd "$disk/target.pcd" -preset fast -format ascii
  check "a full disk: the message says so" says "free some space"
  check "a full disk: the old file stays" [ "$(cat "$disk/target.pcd")" = precious ]
  check "a full disk: nothing is left behind" [ "$(ls "$disk")" = target.pcd ]
  umount "$disk"
  rmdir "$disk"
  disk=
}

read_only ()
{
  local as_user=()
  mkdir locked
  chmod 555 locked
  if [ "$(id -u)" -eq 0 ]; then # root may write anywhere: run as another user
    as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    chmod 755 "$folder"
    chmod a+r ./*.pcd
    "${as_user[@]}" "$smooth" -h >/dev/null 2>&1 || { report skip "a read-only folder: no other user can run the tool"; return; }
  fi
  check "a read-only folder: status 2" run 2 "${as_user[@]}" "$smooth" cloud.pcd locked/target.pcd
  check "a read-only folder: the message says so" says "locked"
  check "a read-only folder: nothing is written" [ -z "$(ls locked)" ]
}

vanishing_input ()
{
  cp large.pcd going.pcd
  "$smooth" going.pcd target.pcd -preset fast -format ascii >out 2>err &
  sleep "$(awk -v t="$duration" 'BEGIN {print t / 2}')"
  rm going.pcd
  wait $!
  local status=$?
  check "the input goes while the tool works: status 0 or 2" [ $status -eq 0 -o $status -eq 2 ]
  if [ $status -eq 0 ]; then
    check "the input goes while the tool works: the output is complete" cmp -s target.pcd large_complete.pcd
  else
    check "the input goes while the tool works: nothing is written" [ ! -e target.pcd ]
  fi
  rm -f target.pcd
}

one_file ()
{
  cp cloud.pcd same.pcd
  check "the input is the output: status 0" run 0 "$smooth" same.pcd same.pcd -preset fast -format ascii
  check "the input is the output: complete" cmp -s same.pcd complete.pcd
  ln -s same.pcd link.pcd
  cp cloud.pcd same.pcd
  check "the output is a link to the input: status 0" run 0 "$smooth" cloud.pcd link.pcd -preset fast -format ascii
  check "the output is a link to the input: it stays one" [ -L link.pcd ]
  check "the output is a link to the input: complete" cmp -s same.pcd complete.pcd
  ln -s nowhere.pcd dangling.pcd
  check "the output is a link to nothing: status 0" run 0 "$smooth" cloud.pcd dangling.pcd -preset fast -format ascii
  check "the output is a link to nothing: complete" cmp -s nowhere.pcd complete.pcd
  rm -f same.pcd link.pcd dangling.pcd nowhere.pcd
}

pipes ()
{
  mkfifo pipe.pcd
  cat pipe.pcd >through.pcd &
  check "the output is a pipe: status 0" run 0 "$smooth" cloud.pcd pipe.pcd -preset fast -format ascii
  wait $!
  check "the output is a pipe: complete" cmp -s through.pcd complete.pcd
  head -c 10 pipe.pcd >/dev/null &
  check "nobody reads the pipe: status 2" run 2 "$smooth" cloud.pcd pipe.pcd -preset fast -format ascii
  check "nobody reads the pipe: the message says so" says "pipe.pcd"
  rm -f pipe.pcd through.pcd
}

closed_streams ()
{
  run 0 "$smooth" cloud.pcd target.pcd -preset fast -format ascii <&-
  check "stdin is closed: complete" cmp -s target.pcd complete.pcd
  rm -f target.pcd
  "$smooth" cloud.pcd target.pcd -preset fast -format ascii >&- 2>&- <&-
  check "all streams are closed: complete" cmp -s target.pcd complete.pcd
  rm -f target.pcd
}

# Less and less memory, starting with enough: success, or status 2 or 3 with a message and nothing written.
no_memory ()
{
  local limit status wrong=0 refused=0
  for ((limit = 1000000; limit > 50000; limit = limit * 97 / 100)); do
    (ulimit -v $limit; exec "$smooth" large.pcd target.pcd -preset fast -format ascii -threads 1) >out 2>err
    status=$?
    [ $status -ne 127 ] || break # not even the libraries fit
    if [ $status -eq 0 ]; then
      cmp -s target.pcd large_complete.pcd || wrong=$((wrong + 1))
    elif [ $status -eq 2 ] || [ $status -eq 3 ]; then
      refused=$((refused + 1))
      [ ! -e target.pcd ] && says memory || wrong=$((wrong + 1))
    else
      wrong=$((wrong + 1))
      echo "status $status with ulimit -v $limit" >>err
    fi
    rm -f target.pcd
  done
  check "memory refused ($refused times): a message, status 2 or 3, nothing written" [ $wrong -eq 0 ]
}

make_clouds
start=$(date +%s.%N)
"$smooth" large.pcd target.pcd -preset fast -format ascii >/dev/null
duration=$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN {print b - a}')
rm target.pcd
before=$(checksums)
for fault in interrupted full_disk read_only vanishing_input one_file pipes closed_streams no_memory killed; do
  $fault
done
check "the input is as it was" as_before
printf '%s failures\n' $failures
[ $failures -eq 0 ]
