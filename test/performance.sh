#!/bin/sh
# The timing command, on little. Usage: performance.sh PERFORMANCE
. "$(dirname "$0")/program.sh"

# An octahedron, and one with a hole.
printf 'OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n' > closed.off
printf '3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n' >> closed.off
sed '$d; s/^6 8 0$/6 7 0/' closed.off > open.off

accepts --help
for option in $(grep -o -- '--[a-z-]*' out); do
  [ "$option" = --help ] ||
    check "the README names $option" grep -q -- "$option" "$here/../benchmark/README.md"
done

refuses FILES
refuses --runs closed.off --runs 0
refuses --time-limit closed.off --time-limit -1
refuses "no such file" none.off --points 100 --csv /dev/null
refuses "cannot write" closed.off --csv nowhere/table.csv

status_of() { # status_of METHOD THREADS: of its total in table.csv
  awk -F, -v m="$1" -v t="$2" '$3 == m && $4 == t && $5 == "total" { print $11 }' table.csv
}

accepts closed.off --points 500 --large 700 --runs 2 --csv table.csv
check "what is asked for, at the end" grep -q "one thread / two threads" out
check "the shares of the stages" grep -q "linking%" out
check "a row of every method and size" test "$(grep -c ',total,2,' table.csv)" = 12
for method in "alpha wrap + MCF" WLOP "Kd_tree 16-NN" "l1_medial stream" "l1_medial bare"; do
  check "$method is there" grep -q "$method,1,total" table.csv
done
check "one thread" test "$(status_of l1_medial 1 | sort -u)" = ok
check "every row has its cells" test "$(awk -F, '{ print NF }' table.csv | sort -u)" = 11

accepts open.off --points 500 --large 0 --runs 1 --csv table.csv
check "an open mesh" test "$(status_of 'MCF of mesh' 1)" = "mesh is open"
accepts closed.off --points 500 --large 0 --time-limit 0.000001 --csv table.csv
check "too long" test "$(status_of l1_medial 1)" = "time limit"

accepts closed.off --points 500 --large 0 --runs 1
check "the table on standard output, its head first" grep -q '^input,' out
check "and all of its rows" grep -q 'Kd_tree 16-NN,1,total' out
finish
