#!/bin/sh
# The regression command, on little. Usage: quality.sh QUALITY
. "$(dirname "$0")/program.sh"

torus() { # torus FILE LAST: quadrilaterals that share no vertex, round the ring up to LAST of 24
  awk -v last="$2" '
    function vertex(i, j,    a, b) {
      a = i * 6.283185307 / 24; b = j * 6.283185307 / 12
      printf "%.6f %.6f %.6f\n", (3 + cos(b)) * cos(a), (3 + cos(b)) * sin(a), sin(b)
    }
    BEGIN {
      print "OFF\n" 4 * 12 * last, 12 * last, 0
      for(i = 0; i < last; ++i)
        for(j = 0; j < 12; ++j) {
          vertex(i, j); vertex((i + 1) % 24, j)
          vertex((i + 1) % 24, (j + 1) % 12); vertex(i, (j + 1) % 12)
        }
      for(i = 0; i < 12 * last; ++i) print 4, 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3
    }' > "$1"
}
torus closed.off 24
torus open.off 20

field() { # field COLUMN ROW: of table.csv, rows from 1
  awk -F, -v name="$1" -v row="$2" 'NR == 1 { for(i = 1; i <= NF; ++i) if($i == name) n = i }
                                    NR == row + 1 { print $n }' table.csv
}

has() { # has COLUMN ROW VALUE
  check "row $2: $1 is $3, not $(field "$1" "$2")" test "$(field "$1" "$2")" = "$3"
}

for command in generated detail meshes clouds scans; do
  accepts "$command" --help
  for option in $(grep -o -- '--[a-z-]*' out); do
    [ "$option" = --help ] ||
      check "the README names $option" grep -q -- "$option" "$here/../benchmark/README.md"
  done
done

refuses subcommand
refuses FILES meshes
refuses --nonsense generated --nonsense
refuses --seeds generated --seeds 0
refuses --points detail --levels 3
refuses --levels detail --points 1000
refuses nonsense generated --families nonsense
refuses nonsense generated --variants nonsense
refuses cannot generated --csv nowhere/table.csv
refuses nonsense scans --variants nonsense
refuses nonsense scans --families nonsense
refuses --places scans --places 7
refuses --families scans --families tree --meshes closed.off
refuses COMPONENTS clouds cloud.xyz:many
refuses "no_such_file" clouds cloud.xyz --beside no_such_file.xyz

accepts generated --families ring --seeds 2 --variants clean,noise_half_percent --points 1000 \
  --csv table.csv
check "a head and a row for every cloud" test "$(wc -l < table.csv)" = 5
for row in 1 2 3 4; do
  has family $row ring
  has comp_true $row 1
  has cycles_true $row 1
  has ends_true $row 0
done
has seed 2 1
has seed 3 2
has variant 4 noise_half_percent
has moved 3 -
cut -d, -f1-19 table.csv > one.csv # not the seconds
accepts generated --families ring --seeds 2 --variants clean,noise_half_percent --points 1000 \
  --csv table.csv --threads 2
cut -d, -f1-19 table.csv > two.csv
check "the same for any number of threads" cmp one.csv two.csv

accepts detail --points 3000 --levels 2 --seeds 2 --first-seed 4 --csv table.csv
check "a head and a row for every seed" test "$(wc -l < table.csv)" = 3
for row in 1 2; do
  has seed $row $((row + 3))
  has points $row 3000
  has ends_true $row 4
  has junctions_true $row 2
  has exact $row yes
done
is_relative() { # is_relative DENSE: with a quarter of the points it is half
  accepts detail --points 750 --levels 2 --first-seed 4 --csv table.csv
  awk -v dense="$1" -v sparse="$(field thinnest 1)" \
    'BEGIN { exit !(dense / sparse > 1.95 && dense / sparse < 2.05) }'
}
check "the thinnest limb is measured in distances between points" is_relative "$(field thinnest 1)"

accepts meshes closed.off open.off nowhere.off --noise 0 --points 1000 --mcf --csv table.csv
has comp_true 1 1
has cycles_true 1 1
has method 2 MCF
has variant 3 "fine mesh"
for row in 2 3; do
  has comp $row 1
  has cycles $row 1
  has exact $row yes
done
has status 4 "mesh is open"
has exact 4 NO
has cycles_true 4 -
check "what is wrong with a file" test "$(field status 7)" != ok

accepts meshes closed.off --noise 0,0.005 --points 3000 --turns 2 --csv table.csv
check "a head and a row for every cloud in every orientation" test "$(wc -l < table.csv)" = 7
has variant 2 "noise 0.005"
has variant 3 "noise 0.000 turn 1"
has variant 6 "noise 0.005 turn 2"
check "turns are grouped by noise" grep -q '^noise 0.005  *default  *3 ' out
for row in 1 3 5; do
  has cycles_true $row 1
  has moved $row -
  has inside $row 1.0000 # of the mesh, which has to be turned as well
done
measured() { sed -n "$(($1 + 1))p" table.csv | cut -d, -f3-16; } # of a row, without the seconds
# Without noise the skeleton follows the turn, to the digits of the table.
check "the cloud is turned" test "$(measured 2)" != "$(measured 4)"

accepts scans --families wire_frame --points 1500 --places 3 --variants clean,drop_outs \
  --csv table.csv
check "a head and two rows for every cloud" test "$(wc -l < table.csv)" = 5
has variant 1 clean
has variant 3 drop_outs
has method 1 default
has method 2 tree
at_least() { # at_least COLUMN ROW VALUE
  check "row $2: $1 is $(field "$1" "$2"), at least $3" \
    awk -v got="$(field "$1" "$2")" -v least="$3" 'BEGIN { exit !(got >= least) }'
}
for row in 2 4; do
  has comp $row 1
  has cycles $row 0
  has exact $row NO # there are loops
  at_least cycles_true $row 1
  at_least found $row 0.9
done

# A mesh has its own counts; an open one has none that could be told.
accepts scans --meshes closed.off open.off --points 3000 --places 1,6 --variants clean,sampled \
  --csv table.csv
check "two rows for every cloud, one for a mesh that is open" test "$(wc -l < table.csv)" = 13
has cloud 1 closed
for row in 1 2 3 4 5 6 7 8; do
  has cycles_true $row 1
done
for row in 5 7; do # from all sides
  has exact $row yes
  at_least found $row 0.9
  at_least true $row 0.9
done
check "that a mesh is open" test "$(field status 9)" = "it is no closed mesh"

awk 'BEGIN { for(i = 0; i < 600; ++i)
  printf "%g %g %g\n", cos(i * 2.4) / 100 , sin(i * 2.4) / 100, i / 600 }' > rod.xyz
printf 'v 0 0 0\nv 0 0 0.5\nv 0 0 1\nv 1 0 1\nl 1 2 3 4\n' > bent.obj # as long beside the rod
printf 'v 0 0 0\nl 1 2\n' > broken.obj
accepts scans rod.xyz:bent.obj rod.xyz:broken.obj rod.xyz nowhere.xyz:bent.obj --csv table.csv
for row in 1 2; do
  has exact $row yes
  has cycles_true $row 0
  has ends_true $row 1 # of the other there are no points
  has true $row 1.000
  has unsupported $row 0.000
  at_least found $row 0.95
done
check "what is wrong with a reference" test "$(field status 3)" != ok
check "that there is none" test "$(field status 4)" != ok
check "what is wrong with a cloud" test "$(field status 5)" != ok

accepts clouds rod.xyz --trees --turns 1 --csv table.csv
for row in 1 2; do
  has trunk $row 3 # z of the file is up however it is turned
done

cp cloud.xyz "a cloud.xyz"
accepts clouds cloud.xyz "a cloud.xyz:5" --as-published --csv table.csv --misses misses
has points 1 600
has exact 1 -
has method 2 published
has comp_true 3 5
has exact 3 NO
check "a miss is written" test -s misses/a_cloud.xyz -a -s misses/a_cloud_default.ply
accepts clouds cloud.xyz:1 --beside "a cloud.xyz" --csv table.csv
has exact 1 yes
accepts clouds cloud.xyz "a cloud.xyz" --turns 2 --csv table.csv
check "a head and a row for every cloud in every orientation" test "$(wc -l < table.csv)" = 7
has points 6 600
has variant 4 ""
has variant 6 "turn 2"
finish
