#!/bin/sh
# The recipes of doc/scaling.md. Usage: recipes.sh PROGRAM
. "$(dirname "$0")/program.sh"
mkdir bin
ln -s "$program" bin/skeletonize_point_set
PATH=$PWD/bin:$PATH
BOX='-2 -2 -1 2 2 13'

mkdir tiles
for k in 0 1 2 3; do awk -v k=$k '$3 >= 3 * k && $3 < 3 * k + 3' cloud.xyz > tiles/$k.xyz; done
ls tiles/*.xyz > files.txt
skeletonize_point_set cloud.xyz --stream --box $BOX --quiet -o expected.ply

# A loop in a shell.
for tile in tiles/*.xyz; do
  skeletonize_point_set accumulate $tile --box $BOX -o ${tile%.xyz}.moments --quiet
done
skeletonize_point_set merge tiles/*.moments -o plot.moments --quiet
skeletonize_point_set plot.moments -o plot.ply --quiet
check "a loop in a shell" cmp expected.ply plot.ply

# An array of jobs: the body of the job, for each number, and the job after it.
script()
{
  awk -v n="$1" '/^    #!\/bin\/sh$/ { ++k; is_inside = 1 } /^$/ { is_inside = 0 }
                 is_inside && k == n { print substr($0, 5) }' "$here/../doc/scaling.md"
}
script 1 > job.sh
script 2 > merge.sh
check "the job is in the manual" grep -q SLURM_ARRAY_TASK_ID job.sh
export BOX
for SLURM_ARRAY_TASK_ID in 4 2 1 3; do
  export SLURM_ARRAY_TASK_ID
  sh job.sh > out
done
rm plot.moments plot.ply
sh merge.sh > out
check "an array of jobs" cmp expected.ply plot.ply

# Dask, where it is.
if /usr/bin/python3 -c 'import dask, point_set_skeletonization' 2> /dev/null; then
  {
    echo "import dask"
    echo "dask.config.set({'scheduler': 'processes', 'multiprocessing.context': 'fork'})"
    echo "box = [float(x) for x in '$BOX'.split()]"
    echo "tiles = [line.strip() for line in open('files.txt')]"
    sed -n '/^```python$/,/^```$/p' "$here/../doc/scaling.md" | sed '1d;$d'
  } > with_dask.py
  cp plot.moments by_the_program.moments
  rm plot.moments plot.ply
  /usr/bin/python3 with_dask.py > out
  check "Dask: the same moments" cmp by_the_program.moments plot.moments
  check "Dask: the same skeleton" cmp expected.ply plot.ply
else
  echo "Without the recipe for Dask: /usr/bin/python3 has no dask, or the Python module was not built"
fi
finish
