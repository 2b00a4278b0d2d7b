#!/usr/bin/env bash
# Runs the commands that README.md shows: those of the tools here, in a folder with the files that they name; every other
# one must be among those that something else runs.
# usage: bash readme_commands.sh <README.md> <folder of the tools>
set -euo pipefail
readme=$(realpath "$1") tools=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
PATH=$tools:$PATH

pcl_make_double_torus torus.ply >made
mkdir scans
for scan in scan.ply scan.pcd scans/a.pcd scans/b.ply; do
  pcl_add_surface_noise torus.ply "$scan" -type GN -sigma 0.2 -seed 1 >>made
done

run=0
while read -r command; do
  case $command in
    *pcl_normal_smoothing_viewer*)
      [ -x "$tools/pcl_normal_smoothing_viewer" ] && command -v Xvfb >/dev/null || continue # optional
      [[ $command == *-screenshot* ]] || continue ;; # test_viewer runs it with a window
    pcl_*) ;;
    scripts/demo.sh* | scripts/test.sh*) continue ;; # .ci/run
    scripts/package.sh* | "cmake -S . -B build "* | "cmake --build build" | "cmake --install build"*) continue ;; # scripts/check_readme.sh
    "cmake --build build --target documentation") continue ;; # the test documentation
    *)
      echo "README.md shows a command that nothing runs: $command" >&2
      exit 1 ;;
  esac
  echo "$command"
  unset DISPLAY
  bash -euc "$command" >said || { echo "README.md shows a command that fails: $command" >&2; exit 1; }
  run=$((run + 1))
done < <(awk '/^```sh/ { on = 1; next } /^```/ { on = 0 } on' "$readme" | sed -E 's/ +#.*//; /^$/d')
[ $run -ge 4 ] || { echo "README.md shows $run commands only: is it written otherwise now?" >&2; exit 1; }

# The tools of its table are those that there are, and no others.
expected=$(cd "$tools" && for tool in pcl_*; do [ ! -x "$tool" ] || [ -d "$tool" ] || echo "$tool"; done | sort)
shown=$(grep -oE '^\| `pcl_[a-z_]+' "$readme" | tr -d '|` ' | sort)
if [ ! -x "$tools/pcl_normal_smoothing_viewer" ]; then shown=$(grep -v viewer <<<"$shown"); fi
diff <(echo "$expected") <(echo "$shown") || { echo "README.md's table of tools is another than what is built" >&2; exit 1; }
