#!/bin/sh
# Pages, pictures, tables of branches and segmented clouds. Usage: program_views.sh PROGRAM
. "$(dirname "$0")/program.sh"

accepts cloud.xyz --quiet -o a.ply -o a.html -o a.png -o a.svg --branches a.csv --segment s.ply
check "a page without gaps" sh -c '! grep -q "{{[a-zA-Z0-9.]*}}" a.html'
check "a PNG file" sh -c 'head -c 4 a.png | grep -q PNG'
check "an SVG file" /usr/bin/python3 -c 'import xml.dom.minidom as x; x.parse("a.svg")'
check "a branch, and only one" test "$(wc -l < a.csv)" = 2
check "its points, order and parent" grep -q '^0,-1,0,0,0,.*,600,' a.csv
check "the table is the library's graph" /usr/bin/python3 "$here/branches/check_tables.py"
accepts cloud.xyz --quiet -o b.html -o b.png -o b.svg --branches b.csv --segment t.ply
for ending in html png svg csv; do
  check "the same again, bit by bit" cmp "a.$ending" "b.$ending"
done
check "the same again, bit by bit" cmp s.ply t.ply

# Endings in capital letters.
accepts cloud.xyz --quiet --branches C.CSV --segment U.PLY --points P.XYZ
check "the same in capital letters" sh -c 'cmp a.csv C.CSV && cmp s.ply U.PLY && test -s P.XYZ'

# From the other end.
awk '{ print -$1, -$2, -$3 }' cloud.xyz > down.xyz
accepts cloud.xyz --quiet --root thickest --up x --branches thick.csv
accepts down.xyz --quiet --branches down.csv
check "it starts below" sh -c "awk -F, 'NR == 2 && \$14 < \$17 { ok = 1 } END { exit !ok }' a.csv"
check "also upside down" sh -c "awk -F, 'NR == 2 && \$14 < \$17 { ok = 1 } END { exit !ok }' down.csv"

# A large cloud is thinned; UTM coordinates keep their digits.
awk 'BEGIN { srand(2); for(i = 0; i < 400000; ++i) { t = rand() * 6.28
  print 500000 + cos(t), 5300000 + sin(t), 10 * rand() } }' OFMT=%.9g > large.xyz
accepts large.xyz --quiet -o large.html
check "at most 5 MB" test "$(wc -c < large.html)" -le 5000000
check "the centre has its digits" grep -q '"centre":\[500000.0[0-9]*,5300000' large.html
accepts large.xyz --quiet --stream -o streamed.html -o streamed.svg --branches streamed.csv
check "no points of a stream" grep -q '"cloud":{"count":0' streamed.html

# Hardly anything to show.
printf '1 2 3\n' > one.xyz
printf '0 0 0\n1 1 1\n' > two.xyz
for file in one two; do
  accepts $file.xyz --quiet -o $file.html -o $file.png -o $file.svg --branches $file.csv \
    --segment $file.seg.ply
done

refuses "'c.txt': name it .csv" cloud.xyz --branches c.txt
refuses "'c.xyz': name it .ply" cloud.xyz --segment c.xyz
refuses "given twice" cloud.xyz -o c.ply --segment c.ply
refuses --segment cloud.xyz --stream --segment c.ply
refuses --root cloud.xyz --root highest
refuses --up cloud.xyz --up w
finish
