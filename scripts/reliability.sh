#!/usr/bin/env bash
# The long runs behind doc/reliability.md, some hours on two cores: sanitizers, fuzzing, damaged files, faults, load,
# coverage, mutations. Prints one line for each at the end.
# usage: scripts/reliability.sh [sanitizers|fuzz|hostile|faults|load|coverage|mutations]...      default: all
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# -gt 0 ] || set -- sanitizers fuzz hostile faults load coverage mutations

"$root/scripts/build.sh" || exit 1
summary=
failed=0
for run in "$@"; do
  printf '\n== %s\n' "$run"
  case $run in
    sanitizers) "$root/scripts/check_sanitizers.sh" ;;
    fuzz) "$root/scripts/reliability/fuzz.sh" ;;
    hostile) python3 "$root/scripts/reliability/mutate_files.py" "$root/build/tools" --count 5000 ;;
    faults) "$root/scripts/reliability/faults.sh" "$root/build/tools" 200 ;;
    load) "$root/scripts/reliability/load.sh" ;;
    coverage) "$root/scripts/reliability/coverage.sh" ;;
    mutations) "$root/scripts/reliability/mutations.py" ;;
    *)
      echo "scripts/reliability.sh: there is no run $run" >&2
      exit 1 ;;
  esac
  status=$?
  [ $status -eq 0 ] || failed=1
  summary+="$run: $([ $status -eq 0 ] && echo passed || echo FAILED)"$'\n'
done
printf '\n%s' "$summary"
exit $failed
