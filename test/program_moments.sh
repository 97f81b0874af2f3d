#!/bin/sh
# Clouds in tiles: files of moments, added up in any way. Usage: program_moments.sh PROGRAM
. "$(dirname "$0")/program.sh"

# A surface of twenty thousand points in four tiles, and with buffers around them.
awk 'BEGIN { for(i = 0; i < 20000; ++i) { a = i * 2.39996; t = (i + 0.5) / 20000
  printf "%.6f %.6f %.6f\n", 500000 + (1 + 0.3 * sin(9 * t)) * cos(a), (1 + 0.3 * sin(9 * t)) * sin(a), 12 * t } }' \
  > all.xyz
box="499998 -2 -1 500002 2 13"
tile() { # tile NAME FROM TO BUFFER
  awk -v from="$2" -v to="$3" -v buffer="$4" '$3 >= from - buffer && $3 < to + buffer' all.xyz > "$1"
}
for buffer in 0 1; do
  for k in 0 1 2 3; do tile "tile${k}_$buffer.xyz" $((3 * k)) $((3 * k + 3)) $buffer; done
done
check "buffers overlap" test "$(cat tile?_1.xyz | wc -l)" -gt 24000

accepts accumulate all.xyz --box $box -o all.moments
check "says what it has" one_line out "all.moments: points 20000, cells" "tiles 1"
accepts all.moments --quiet -o expected.ply
accepts all.xyz --stream --box $box --quiet -o streamed.ply
check "the same as streamed" cmp expected.ply streamed.ply
accepts all.moments --stats -o expected.swc
check "the points are counted" one_line out '"points":20000,'

# Coarser cells, of points in any form.
cells_of() { # cells_of ARGUMENT...
  accepts "$@" --stats
  sed 's/.*"mixture":\([0-9]*\),"samples".*/\1/' out
}
check "coarser" test "$(cells_of all.moments --smallest-feature 1)" -lt "$(cells_of all.moments)"
accepts all.xyz --smallest-feature 1 --quiet -o at_once.ply
accepts all.xyz --smallest-feature 1 --quiet --stream -o streamed.ply
check "coarser cells of a stream, as of points in memory" cmp at_once.ply streamed.ply
accepts all.xyz --smallest-feature 1e-9 --quiet --stream --box $box -o found.ply
check "finer than the points allow is no finer" cmp expected.ply found.ply

same_skeleton() { # same_skeleton FILE.moments
  accepts "$1" --quiet -o found.ply
  check "$1: the same skeleton, bit for bit" cmp expected.ply found.ply
}
accepts accumulate tile0_0.xyz tile1_0.xyz tile2_0.xyz tile3_0.xyz --box $box -o forth.moments
same_skeleton forth.moments
accepts accumulate tile2_0.xyz tile0_0.xyz tile3_0.xyz tile1_0.xyz --box $box -o mixed.moments --quiet
check "the same file for any order of the tiles" cmp forth.moments mixed.moments
for k in 0 1 2 3; do accepts accumulate tile${k}_0.xyz --box $box -o part$k.moments --quiet; done
accepts merge part3.moments part1.moments part0.moments part2.moments -o merged.moments
check "the same file for parts" cmp forth.moments merged.moments
accepts merge part2.moments part0.moments -o even.moments --quiet
accepts merge part1.moments part3.moments -o odd.moments --quiet
accepts merge odd.moments even.moments -o merged.moments --quiet
check "the same file for parts of parts" cmp forth.moments merged.moments

# Tiles with buffers: every point counts once.
for k in 0 1 2 3; do
  accepts accumulate tile${k}_1.xyz --box $box --tile-box -1e9 -1e9 $((3 * k)) 1e9 1e9 $((3 * k + 3)) \
    -o buffered.moments --append --quiet
done
same_skeleton buffered.moments
{ echo '# four tiles'; for k in 0 1 2 3; do
    echo "tile${k}_1.xyz -inf -inf $((3 * k)) inf inf $((3 * k + 3))"; done; } > tiles.txt
accepts accumulate --tiles tiles.txt -o listed.moments --box $box
check "the points of the list" one_line out "points 20000,"
same_skeleton listed.moments
sort -r tiles.txt > reversed.txt
accepts accumulate --tiles reversed.txt -o reversed.moments --box $box --quiet
check "the same file for any order of the list" cmp listed.moments reversed.moments

# Without a box the tiles are read twice, as for --stream.
accepts accumulate tile?_0.xyz -o found_box.moments --quiet
accepts found_box.moments --quiet -o found.ply
accepts all.xyz --stream --quiet -o streamed.ply
check "the box of the bulk of all tiles" cmp streamed.ply found.ply
accepts all.xyz --quiet -o at_once.ply
check "the same as of points in memory" cmp at_once.ply found.ply

# It goes on where it was: what is in it is not counted again.
echo nonsense > bad.xyz
run accumulate tile0_0.xyz tile1_0.xyz bad.xyz --box $box -o going.moments --append --quiet
check "a bad tile: exit code 1, not $code" test "$code" = 1
check "a bad tile is named" one_line err "'bad.xyz': line 1"
accepts going.moments --stats
check "what came before is kept" grep -q '"points":10000,' out
accepts accumulate tile0_0.xyz tile1_0.xyz tile2_0.xyz tile3_0.xyz --box $box -o going.moments --append
check "says what was in it" grep -q '^2 tiles were in it before$' out
check "the same file" cmp forth.moments going.moments
refuses "'going.moments': it has another --box" accumulate tile0_0.xyz --box 0 0 0 1 1 1 \
  -o going.moments --append

# What does not go together.
refuses "cannot add 'part0.moments': it has 'tile0_0.xyz' as well" merge forth.moments part0.moments \
  -o c.moments
accepts accumulate tile0_0.xyz -o other_box.moments --quiet
refuses "cannot add 'other_box.moments': it has another box" merge part1.moments other_box.moments \
  -o c.moments
accepts accumulate tile0_0.xyz --box $box --cells 2000 -o coarse.moments --quiet
refuses "cannot add 'coarse.moments': it has another bound" merge part1.moments coarse.moments -o c.moments
refuses "'tile0_0.xyz' is given twice" accumulate tile0_0.xyz tile0_0.xyz --box $box -o c.moments
refuses "outside the given box" accumulate tile0_0.xyz --box 0 0 0 1 1 1 -o c.moments
refuses "'c.ply': name it .moments" accumulate tile0_0.xyz -o c.ply
refuses "'none/c.moments': there is no folder" accumulate tile0_0.xyz -o none/c.moments
refuses "give a TILE" accumulate -o c.moments
refuses "'none.xyz': there is no such file" accumulate tile0_0.xyz none.xyz --box $box -o c.moments
refuses "--tile-box: give the smallest" accumulate tile0_0.xyz --tile-box 1 0 0 0 1 1 -o c.moments
echo 'tile0_0.xyz 1 0 0 0 1 1' > bad.txt
refuses "'bad.txt': line 1: give the smallest" accumulate --tiles bad.txt -o c.moments
refuses "--segment" all.moments --segment s.ply
refuses "--points" all.moments --points s.xyz
refuses "--cells" all.moments --cells 5000
refuses "--as-published" all.moments --as-published

# Files that are no moments, or no longer.
cp all.xyz foreign.moments
head -c 1000 all.moments > cut.moments
{ head -c 2000 all.moments; printf x; tail -c +2002 all.moments; } > flipped.moments
: > empty.moments
refuses "'foreign.moments': it is no file of moments" foreign.moments
refuses "'empty.moments': it is no file of moments" empty.moments
refuses "'cut.moments': it breaks off" cut.moments
refuses "'flipped.moments': it is damaged" flipped.moments
refuses "'none.moments': there is no such file" none.moments
refuses "'cut.moments': it breaks off" merge all.moments cut.moments -o c.moments
refuses "'cut.moments': it breaks off" accumulate tile0_0.xyz -o cut.moments --append

# A disk that is full: what was there stays.
cp part0.moments full.moments
before=$(ls -A)
code=0
(trap '' XFSZ; ulimit -f 20; "$program" accumulate tile1_0.xyz --box $box -o full.moments --append --quiet \
  2> err) || code=$?
check "a full disk: exit code 1, not $code" test "$code" = 1
check "a full disk: one line" one_line err "'full.moments'" "free space"
check "a full disk: the older file is still there" cmp full.moments part0.moments
check "a full disk: no other file" test "$before" = "$(ls -A)"

# Ended on the way: no file, or the older one.
mkfifo slow.xyz
"$program" accumulate slow.xyz --box $box -o slow.moments --quiet & child=$!
exec 3> slow.xyz
head -n 2000 all.xyz >&3
kill -TERM $child
code=0
wait $child || code=$?
exec 3>&-
check "ended by a signal, not by itself: $code" test "$code" -gt 128
check "no half file" test ! -e slow.moments -a -z "$(ls -A | grep part$)"

# A skeleton for each part that touches no other, the largest first.
awk '{ print; if(NR % 2) printf "%.6f %s %s\n", $1 + 10, $2, $3 }' all.xyz > two.xyz
accepts two.xyz --split -o part.ply -o part.polylines.txt -o part.tubes.ply --branches part.csv
check "a line for each part" test "$(wc -l < out)" = 2
check "which says how large it is" grep -q '^part 2: points 10000, ' out
check "files for each part" test "$(ls part_* | tr '\n' ' ')" = "$(for part in 1 2; do
  printf '%s ' part_$part.csv part_$part.ply part_$part.polylines.txt part_$part.tubes.ply; done)"
accepts accumulate two.xyz -o two.moments --quiet
accepts two.moments --split --threads 1 -o again.ply --stats
check "statistics for each part" grep -q '^{"part":2,"points":10000,' out
check "the same of moments, on any number of threads" sh -c \
  'cmp part_1.ply again_1.ply && cmp part_2.ply again_2.ply'
refuses "--segment" two.xyz --split --segment s.ply

for command in accumulate merge; do
  accepts $command --help
  check "$command --help" grep -q -- --output out
done
accepts --help
check "--help names the commands" sh -c 'grep -q "^  accumulate" out && grep -q "^  merge" out'
finish
