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
for length in 0 -1 nan inf; do
  refuses "--smallest-feature: give a length" cloud.xyz --smallest-feature $length
done
refuses "--smallest-feature" cloud.xyz --smallest-feature thin
refuses "--as-published" cloud.xyz --as-published --smallest-feature 1

accepts cloud.xyz
check "a summary" one_line out "points 600" "components"
accepts cloud.xyz --single-component
check "a single component" one_line out "components 1"
accepts cloud.xyz --tree
check "no cycle" one_line out "cycles 0"
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
for option in --h0 --delta-h --iterations --mu --samples --alpha --levels --flatness \
  --sample-flatness --alpha-min --b-min --d-max; do
  refuses --as-published cloud.xyz $option "$([ $option = --mu ] && echo 0.3 || echo 2)"
  refuses "$option" cloud.xyz --as-published $option -1
done
refuses --as-published cloud.xyz --tuned
refuses --as-published cloud.xyz --halt
# The defaults by their symbols are the defaults.
accepts cloud.xyz --quiet --as-published --delta-h 0.5 --iterations 30 --mu 0.2 --samples 500 \
  --alpha 2.2 --levels 3 --flatness 0.3 --sample-flatness 0.3 --alpha-min 90 --b-min 5 \
  --d-max 0.15 -o symbols.ply
check "the defaults by their symbols" cmp published.ply symbols.ply
accepts cloud.xyz --quiet --as-published --tuned -o tuned.ply
accepts cloud.xyz --quiet --as-published --tuned --delta-h 0.333333333333333333 --iterations 60 \
  --sample-flatness 0.05 --alpha-min 120 -o symbols.ply
check "the tuned set by its symbols" cmp tuned.ply symbols.ply
check "it is another" sh -c '! cmp -s published.ply tuned.ply'
accepts cloud.xyz --stats --as-published --iterations 7
check "other iterations" one_line out '"iterations":7,'
accepts cloud.xyz --quiet --as-published --seed 4 -o seed4.ply
check "another seed, another skeleton as published" sh -c '! cmp -s published.ply seed4.ply'
accepts cloud.xyz --quiet --threads 1 --seed 3 -o one.ply
accepts cloud.xyz --quiet --threads 2 --seed 3 -o two.ply
check "the same for any number of threads" cmp one.ply two.ply
finish
