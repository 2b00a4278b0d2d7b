#!/usr/bin/env bash
# Installs what is missing, builds, runs the study and makes its report: one page. Interrupted, the same command goes on.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage="usage: evaluation/study.sh [-small] [-scan file] [-out folder] [-built folder] [mesh [-subdivide N]]... [-- option]...

  mesh           PLY, OBJ, OFF or STL, clean: noise is added to its vertices. Studied beside the shapes made in code
  -subdivide N   splits the edges of the mesh before it N times: fandisk.off -subdivide 1
  -small         the double torus and the peers' defaults alone, in less than 2 minutes
  -scan file     a real scan, PCD or PLY, for the page's Fig. 9
  -out folder    where the results go (default: study_output, with -small study_output_small)
  -built folder  a build folder with the tools in it: nothing is installed or built
  -- option...   options of pcl_smoothing_study: -- -seeds 5 -sigma 0.1,0.2"

fail ()
{
  echo "evaluation/study.sh: $1" >&2
  exit "${2:-1}"
}

small=0 scan="" out="" built="" meshes=() splits=() options=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) echo "$usage"; exit 0 ;;
    -small) small=1 ;;
    --) shift; options=("$@"); break ;;
    -scan | -out | -built | -subdivide)
      [ $# -gt 1 ] || fail "$1 needs a value"
      case "$1" in
        -scan) [ -r "$2" ] || fail "cannot read $2: give it a PCD or PLY file" 2; scan=$2 ;;
        -out) out=$2 ;;
        -built) built=$2 ;;
        -subdivide) [ ${#meshes[@]} -gt 0 ] || fail "-subdivide goes behind a mesh"; splits[${#meshes[@]} - 1]=$2 ;;
      esac
      shift ;;
    -*) echo "$usage" >&2; fail "unknown option $1" ;;
    *) [ -r "$1" ] || fail "cannot read $1" 2; meshes+=("$1"); splits+=(0) ;;
  esac
  shift
done

if [ -z "$built" ]; then
  "$root/evaluation/install_report.sh"
  "$root/evaluation/install_peers.sh" || echo "Not every peer could be installed: the report will show gaps." >&2
  "$root/scripts/build.sh" -DBUILD_EVALUATION=ON tools/all evaluation/all
  built=$root/build
fi

arguments=()
if [ ${#meshes[@]} -gt 0 ]; then
  arguments+=("${meshes[@]}" -subdivide "$(IFS=,; echo "${splits[*]}")")
fi
if [ $small -eq 1 ]; then
  arguments+=(-small 1 -models double_torus)
  out=${out:-$root/study_output_small}
else
  arguments+=(-models "double_torus,double_torus_round,csg_part,organic,plate,two_sheets,two_sheets_apart")
  out=${out:-$root/study_output}
fi

# Threads that wait must not keep the cores from the peers.
OMP_WAIT_POLICY=passive "$built/evaluation/pcl_smoothing_study" "$out" "${arguments[@]}" "${options[@]}"
# Debian's Python, which Debian's packages belong to.
python=/usr/bin/python3
[ -x $python ] || python=python3
$python "$root/evaluation/report/make_report.py" "$out" -tools "$built/tools" ${scan:+-scan "$scan"} >/dev/null
echo "The report: $out/report/index.html"
