#!/bin/sh
# Many processes give what one gives, bit for bit, and end together.
# Usage: program_mpi.sh MPIRUN PROGRAM_MPI PROGRAM
mpirun=$1 mpi_program=$2
shift 2
. "$(dirname "$0")/program.sh"
# More processes than cores (said to Open MPI 4, then to 5), perhaps as root, perhaps in a container,
# perhaps on a machine without a network.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
  OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe \
  OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_mpi_yield_when_idle=1 \
  OMPI_MCA_btl_tcp_if_include=lo HWLOC_HIDE_ERRORS=2 # about a chroot without /sys
# Without a file /etc/hosts each start asks a server for "localhost", and waits for no answer.
export RES_OPTIONS="timeout:1 attempts:1"
ranks=1
mpi() { "$mpirun" -n $ranks "$mpi_program" "$@"; }
single=$program

awk 'BEGIN { for(i = 0; i < 20000; ++i) { a = i * 2.39996; t = (i + 0.5) / 20000
  printf "%.6f %.6f %.6f\n", (1 + 0.3 * sin(9 * t)) * cos(a), (1 + 0.3 * sin(9 * t)) * sin(a), 12 * t } }' > all.xyz
echo 1e12 0 0 >> all.xyz # far from all others
for k in 0 1 2 3 4; do
  awk -v k=$k '($3 >= 2.4 * k && $3 < 2.4 * (k + 1)) || (k == 0 && $3 == 0 && $1 > 9)' all.xyz > tile$k.xyz
  awk -v k=$k '$3 >= 2.4 * k - 0.5 && $3 < 2.4 * (k + 1) + 0.5' all.xyz > wide$k.xyz
  echo "wide$k.xyz -inf -inf $(awk "BEGIN { print 2.4 * $k }") inf inf $(awk "BEGIN { print 2.4 * ($k + 1) }")"
done > wide.txt
"$single" all.xyz --quiet --stream -o expected.ply
"$single" all.xyz --quiet --segment expected_segments.ply -o in_memory.ply
check "in memory as streamed" cmp expected.ply in_memory.ply

program=mpi
for ranks in 1 2 3 4; do
  accepts tile0.xyz tile1.xyz tile2.xyz tile3.xyz tile4.xyz -o found.ply --quiet
  check "$ranks processes: the same skeleton" cmp expected.ply found.ply
  accepts tile3.xyz tile1.xyz tile4.xyz tile0.xyz tile2.xyz -o found.ply --segment-directory seg$ranks --quiet
  check "$ranks processes, other order: the same skeleton" cmp expected.ply found.ply
  accepts --tiles wide.txt -o found.ply --quiet
  check "$ranks processes, tiles with buffers: the same skeleton" cmp expected.ply found.ply
done
check "the points of each tile are written" test "$(ls seg4 | tr '\n' ,)" = \
  tile0.ply,tile1.ply,tile2.ply,tile3.ply,tile4.ply,
for k in 0 1 2 3 4; do check "tile $k: the same points for any ranks" cmp seg1/tile$k.ply seg4/tile$k.ply; done

# The same branch, order and distance for each point as in one process.
points_of() { # without the header; a point has 40 bytes
  for file in "$@"; do tail -c $((40 * $(sed -n 's/^element vertex //p' "$file"))) "$file"; done |
    od -An -v -t x1 -w40 | sort
}
points_of expected_segments.ply > expected.txt
points_of seg3/*.ply > found.txt
check "the same branches of points as in one process" cmp expected.txt found.txt

ranks=3
"$single" all.xyz --quiet --smallest-feature 1 -o coarse.ply
accepts tile?.xyz --smallest-feature 1 -o found.ply --quiet
check "coarser cells, as in one process" cmp coarse.ply found.ply
accepts tile?.xyz --stats
check "says all about the run" one_line out '"points":20001,' '"outliers":' '"megabytes":['
accepts tile?.xyz -o found.ply --branches branches.csv
check "and in short" one_line out "points 20001, outliers"
check "a table of branches" test -s branches.csv

# One cannot go on: it says why, and all stop.
stops() { # stops TEXT ARGUMENT...
  text=$1
  shift
  run "$@"
  check "$*: exit code 1, not $code" test "$code" = 1
  check "$*: nothing on standard output" test ! -s out
  grep '^skeletonize_point_set' err > said || true
  check "$*: says one line" one_line said "$text"
  check "$*: no skeleton" test ! -e stopped.ply
}
echo nonsense > bad.xyz
stops "'bad.xyz': line 1" tile?.xyz bad.xyz -o stopped.ply
stops "'none.xyz': there is no such file" tile?.xyz none.xyz -o stopped.ply
stops "outside the given box" tile?.xyz --box -2 -2 -1 1e13 2 9.7 -o stopped.ply
stops "'tile1.xyz' is given twice" tile?.xyz tile1.xyz -o stopped.ply
stops "'none/stopped.ply': there is no folder" tile?.xyz -o none/stopped.ply
stops "give a TILE" -o stopped.ply
stops "--smallest-feature: give a length" tile?.xyz --smallest-feature 0 -o stopped.ply
stops "'none.txt': there is no such file" --tiles none.txt -o stopped.ply
mkdir other
cp tile1.xyz other
stops "another tile has the same name" tile?.xyz other/tile1.xyz --segment-directory segments -o stopped.ply

# A disk that is full. Processes talk without files then.
program=full_disk
full_disk() {
  OMPI_MCA_btl=self,tcp "$mpirun" -n $ranks sh -c 'trap "" XFSZ; ulimit -f 1; exec "$0" "$@"' \
    "$mpi_program" "$@"
}
stops "'stopped.ply': check the free space" tile?.xyz -o stopped.ply
program=mpi

# One is killed while it reads.
for signal in KILL TERM; do
  mkfifo slow.xyz
  "$mpirun" -n 3 "$mpi_program" tile0.xyz tile1.xyz slow.xyz --box -2 -2 -1 1e13 2 13 --quiet -o stopped.ply \
    > out 2> err & child=$!
  exec 3> slow.xyz
  head -n 1000 tile2.xyz >&3
  victim=$(pgrep -P $child | tail -n 1)
  kill -$signal "$victim"
  code=0
  wait $child || code=$?
  exec 3>&-
  rm slow.xyz
  check "killed by $signal: not a success" test "$code" != 0
  check "killed by $signal: no skeleton and no half file" test ! -e stopped.ply -a -z "$(ls -A | grep 'part$')"
done

accepts --help
check "--help" grep -q -- --segment-directory out
finish
