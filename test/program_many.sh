#!/bin/sh
# Many files in one call. Usage: program_many.sh PROGRAM
. "$(dirname "$0")/program.sh"

mkdir -p in other
awk '{ print $1, $2, 2 * $3 }' cloud.xyz > in/long.xyz
cp cloud.xyz 'in/with blank.xyz'
cp cloud.xyz other/long.xyz
echo nonsense > in/bad.xyz
accepts cloud.xyz 'in/with blank.xyz' in/long.xyz --output-directory out1 -f ply -f swc
check "a line for each" test "$(wc -l < out)" = 3
check "each with its name" grep -q '^in/with blank.xyz: points 600, ' out
check "all outputs" test "$(ls out1 | tr '\n' ,)" = \
  'cloud.ply,cloud.swc,long.ply,long.swc,with blank.ply,with blank.swc,'
accepts in/long.xyz --quiet -o alone.ply
check "the same as alone" cmp alone.ply out1/long.ply

run cloud.xyz in/bad.xyz none.xyz in/long.xyz --output-directory out2 -f ply
check "exit code 1" test "$code" = 1
check "a line for each that failed" test "$(wc -l < err)" = 2
check "which says why" grep -q "'none.xyz': there is no such file" err
check "the others are done" test "$(ls out2 | tr '\n' ,)" = 'cloud.ply,long.ply,'
check "and reported" test "$(wc -l < out)" = 2
accepts cloud.xyz --output-directory out2 -f ply --stats
check "statistics with the name" one_line out '{"input":"cloud.xyz","points":600'

refuses "'in/long.xyz' as a second input" cloud.xyz in/long.xyz
refuses "'b.obj' as a second input" cloud.xyz -o a.ply b.obj
refuses "'other/long.xyz': another input has the same name" in/long.xyz other/long.xyz \
  --output-directory out3 -f ply
refuses "'out3/cloud.stl': name it" cloud.xyz --output-directory out3 -f stl
refuses --output-directory cloud.xyz -f ply
refuses --output-format cloud.xyz --output-directory out3
refuses --output cloud.xyz --output-directory out3 -f ply -o a.ply
refuses "cannot create the folder 'cloud.xyz'" cloud.xyz --output-directory cloud.xyz -f ply

accepts --version
check "the version" one_line out "skeletonize_point_set "
accepts cloud.xyz
check "what could be written" one_line out "-o FILE writes .html"
finish
