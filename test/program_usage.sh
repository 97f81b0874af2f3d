#!/bin/sh
# The options of the program. Usage: program_usage.sh PROGRAM
. "$(dirname "$0")/program.sh"

accepts --help
for option in $(grep -o -- '--[a-z-]*' out); do
  [ "$option" = --help ] || [ "$option" = --output ] ||
    check "the README names $option" grep -q -- "$option" "$here/../README.md"
done

refuses INPUT
refuses --nonsense cloud.xyz --nonsense
refuses cloud2.xyz cloud.xyz cloud2.xyz
refuses --sample cloud.xyz --sample 0
refuses --sample cloud.xyz --sample many
refuses --sample cloud.xyz --sample -5
refuses --threads cloud.xyz --threads 0
refuses --threads cloud.xyz --threads 1.5
refuses --seed cloud.xyz --seed x
refuses --sample cloud.xyz --stream --sample 10
refuses --points cloud.xyz --stream --points points.xyz
refuses --as-published cloud.xyz --stream --as-published
refuses --stream cloud.xyz --box 0 0 0 1 1 1
refuses --box cloud.xyz --stream --box 0 0 0 1 1
refuses "smallest x, y and z" cloud.xyz --stream --box 0 0 0 1 -1 1
refuses "smallest x, y and z" cloud.xyz --stream --box 0 0 0 1 inf 1
refuses "no faces" cloud.xyz --sample 100

accepts cloud.xyz
check "a summary" one_line out "points 600" "components"
accepts cloud.xyz --single-component
check "a single component" one_line out "components 1"
accepts cloud.xyz --quiet
check "quiet" test ! -s out

accepts cloud.xyz --stats
order='"points":600,"mixture":[0-9]*,"samples":[0-9]*,"components":.*"cycles":.*"ends":.*"junctions":'
order=$order'.*"length":.*"seconds":{"mixture":.*"projection":.*"linking":'
check "one line of statistics" one_line out "{"
check "the figures in their order" grep -q "^{$order.*\"total\":.*}}\$" out
accepts cloud.xyz --stats --stream
check "the reading of a stream" one_line out '"seconds":{"reading":'
accepts cloud.xyz --stats --quiet
check "statistics although quiet" one_line out '"points":600'

accepts cloud.xyz --quiet --as-published -o published.ply
accepts cloud.xyz --stats --as-published
check "the iterations of the published method" one_line out '"iterations":30,"components":'
accepts cloud.xyz --quiet --as-published --seed 4 -o seed4.ply
check "another seed, another skeleton as published" sh -c '! cmp -s published.ply seed4.ply'
accepts cloud.xyz --quiet --threads 1 --seed 3 -o one.ply
accepts cloud.xyz --quiet --threads 2 --seed 3 -o two.ply
check "the same for any number of threads" cmp one.ply two.ply
finish
