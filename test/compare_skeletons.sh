#!/bin/sh
# The comparison, on little. Usage: compare_skeletons.sh COMPARE_SKELETONS
. "$(dirname "$0")/program.sh"

torus() { # torus FILE: a closed mesh
  awk '
    function vertex(i, j,    a, b) {
      a = i * 6.283185307 / 24; b = j * 6.283185307 / 12
      printf "%.6f %.6f %.6f\n", (3 + cos(b)) * cos(a), (3 + cos(b)) * sin(a), sin(b)
    }
    BEGIN {
      print "OFF\n" 24 * 12, 24 * 12, 0
      for(i = 0; i < 24; ++i) for(j = 0; j < 12; ++j) vertex(i, j)
      for(i = 0; i < 24; ++i)
        for(j = 0; j < 12; ++j)
          print 4, 12 * i + j, 12 * ((i + 1) % 24) + j, 12 * ((i + 1) % 24) + (j + 1) % 12,
                12 * i + (j + 1) % 12
    }' > "$1"
}
torus torus.off

row() { # row INPUT NOISE METHOD KIND: of results.csv; no cell has a comma before its message
  awk -F, -v i="$1" -v n="$2" -v m="$3" -v k="$4" \
    '$1 == i && $2 == n && $3 == m && $4 == k' out1/results.csv
}

has() { # has INPUT NOISE METHOD KIND COLUMN VALUE
  value=$(row "$1" "$2" "$3" "$4" | cut -d, -f"$(head -n 1 out1/results.csv | tr , '\n' |
    grep -nx "$5" | cut -d: -f1)")
  check "$1 $2 $3 $4: $5 is $6, not '$value'" test "$value" = "$6"
}

accepts --help
for option in $(grep -o -- '--[a-z-]*' out); do
  [ "$option" = --help ] ||
    check "the README names $option" grep -q -- "$option" "$here/../benchmark/README.md"
done
for method in l1_medial l1_medial_published l1_medial_published_tuned mcf wrap_mcf poisson_mcf \
    l1_wlop rosa lapcon10 lapcon08_vc lapcon08_ec wave_fronts teasar tangent_ball; do
  check "--help names $method" grep -q "^ *$method:" out
done

refuses INPUT --output out1
refuses --output torus.off
refuses --nonsense torus.off --output out1 --nonsense
refuses "no method 'nonsense'" torus.off --output out1 --methods l1_medial,nonsense
refuses --noise torus.off --output out1 --noise -0.1
refuses --noise torus.off --output out1 --noise much
refuses --seeds torus.off --output out1 --seeds 0
refuses --time-limit torus.off --output out1 --time-limit 0
refuses torus.off torus.off --output torus.off

accepts torus.off cloud.xyz nowhere.off --output out1 --points 1000 --noise 0.005,0 --decimate \
  --methods l1_medial,mcf,poisson_mcf --seed 3
check "a head and a row for every method, input and noise" \
  test "$(wc -l < out1/results.csv)" = $((1 + 2 * (4 + 3 + 3)))
check "no file is left over" test "$(ls out1 | tr '\n' ' ')" = "report.html results.csv "
check "a report" grep -q "</html>" out1/report.html
for noise in 0.0000 0.0050; do
  for run in l1_medial,points mcf,mesh "mcf,decimated mesh" poisson_mcf,points+normals; do
    method=${run%,*} kind=${run#*,}
    has torus $noise "$method" "$kind" status ok
    has torus $noise "$method" "$kind" components_true 1
    has torus $noise "$method" "$kind" cycles_true 1
    has torus $noise "$method" "$kind" points 1000
    has torus $noise "$method" "$kind" seed 3
  done
  has torus $noise l1_medial points cycles 1
  has torus $noise mcf mesh cycles 1
  has cloud $noise l1_medial points status ok
  has cloud $noise mcf "wrapped mesh" components_true -
  has nowhere $noise mcf mesh status unreadable
done
check "normals are a stage" sh -c 'grep poisson_mcf out1/results.csv | grep -q "normals="'
check "a wrap is a stage" sh -c 'grep "wrapped mesh" out1/results.csv | grep -q "wrap="'
has torus 0.0000 mcf mesh moved -
check "noise moves" test "$(row torus 0.0050 mcf mesh | cut -d, -f22)" != -

accepts ring:1 ring:none --output out1 --points 2000 --noise 0,0.01 --methods l1_medial,lapcon10,mcf
for noise in 0.0000 0.0100; do
  has ring:1 $noise l1_medial points components_true 1
  has ring:1 $noise l1_medial points cycles_true 1
  has ring:1 $noise l1_medial points ends_true 0
  has ring:1 $noise mcf mesh cycles 1
  has ring:none $noise mcf mesh status unreadable
done
check "how this package stands among methods that take raw points" \
  grep -q "^l1_medial is first or within 5 % of the first in [0-9]* of 9 figures" out

accepts filigree:1 --output out1 --points 20000 --methods l1_medial
has filigree:1 0.0000 l1_medial points cycles_true 15
has filigree:1 0.0000 l1_medial points ends_true 0

accepts torus.off --output out1 --points 1000 --noise 0,0.01 --seed 5 --seeds 2 --methods l1_medial,lapcon10
check "a row for every method, noise and seed" test "$(wc -l < out1/results.csv)" = 9
for seed in 5 6; do
  check "rows of seed $seed" test "$(cut -d, -f26 out1/results.csv | grep -c "^$seed$")" = 4
done
# With noise there are more figures: they are rounded, and one of two clouds may be the same.
check "clouds of their own" \
  test "$(grep -c ",0.0100," out1/results.csv)" = \
       "$(grep ",0.0100," out1/results.csv | cut -d, -f18,19,21-23 | sort -u | wc -l)"

accepts torus.off --output out1 --points 100000 --time-limit 0.05 --methods l1_medial
has torus 0.0000 l1_medial points status time_limit
has torus 0.0000 l1_medial points components -
check "nothing is said of one method" sh -c '! grep -q "first or within" out'
finish
