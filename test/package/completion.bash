# What bash offers: the options of a tool, the words that an option takes, folders and clouds.
# usage: bash completion.bash <completion file> <folder of the tools>
set -u # as a shell that people use: what finds nothing is no error
. "$1"
PATH=$2:$PATH

# expect "words offered" previous current
expect ()
{
  _pcl_normal_smoothing pcl_normal_smoothing "$3" "$2"
  [ "${COMPREPLY[*]}" = "$1" ] || { echo "after '$2', '$3' offers '${COMPREPLY[*]}', not '$1'" >&2; exit 1; }
}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
touch "$folder"/scan.pcd "$folder"/notes.txt
cd "$folder"
expect "-preset -point_iterations -point_spacing" pcl_normal_smoothing -p
expect "default fast paper" -preset ""
expect "fast" -preset f
expect "scan.pcd" pcl_normal_smoothing ""
expect "" -k ""
