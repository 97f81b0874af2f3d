#!/bin/sh
# Files that are damaged on purpose or by accident: never a crash, never a hang, never memory that the
# file does not have. Usage: program_robust.sh PROGRAM
. "$(dirname "$0")/program.sh"

# One second and 1 GB are plenty for what is refused.
refuses_at_once() {
  plain=$program
  program=limited
  refuses "$@"
  program=$plain
}
limited() {
  (ulimit -v 1000000; exec timeout -s KILL 10 "$plain" --threads 1 "$@")
}

# Where readers trust what they read.
printf 'COFF\n1 0 0\n0 0 0 -99999999\n' > colour.off
accepts colour.off
check "a colour is of no interest" one_line out "points 1,"
ply='ply\nformat ascii 1.0\n'
point='element vertex 1\nproperty float x\nproperty float y\nproperty float z\n'
printf "${ply}property float x\n${point}end_header\n0 0 0\n" > property_first.ply
printf "${ply}element foo 1000000000000\n${point}end_header\n0 0 0\n" > many.ply
printf "${ply}element foo 1000000000000\nproperty int i\n${point}end_header\n0 0 0\n" > many_rows.ply
printf "${ply}element vertex -1\nproperty float x\nend_header\n" > negative.ply
sed 's/ascii/binary_little_endian/' many_rows.ply > many_bytes.ply
printf 'ply\nformat binary_little_endian 1.0\n%belement face 1\nproperty list uint int vertex_indices\n' \
  "$point" > list.ply
printf 'end_header\n\0\0\0\0\0\0\0\0\0\0\0\0\0\050\153\356' >> list.ply # 4e9 vertices
printf 'OFF\n3 1000000000 0\n0 0 0\n1 0 0\n0 1 0\n' > faces.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n' > corners.off
printf 'OFF BINARY\n\377\377\377\377\377\377\377\377\0\0\0\0' > counts.off
head -c 30000000 /dev/zero | tr '\0' 1 > endless.xyz
for stream in '' --stream; do
  refuses_at_once "'property_first.ply': line 3 is not understood" property_first.ply $stream
  refuses_at_once "'many_rows.ply': line 10 is the last" many_rows.ply $stream
  refuses_at_once "'many_bytes.ply': it breaks off" many_bytes.ply $stream
  refuses_at_once "'negative.ply': line 3 is not understood" negative.ply $stream
  refuses_at_once "'list.ply': it breaks off or is damaged after 1 points" list.ply $stream
  refuses_at_once "'faces.off': line 5 is the last" faces.off $stream
  refuses_at_once "'corners.off': line 6 is not understood" corners.off $stream
  refuses_at_once "'counts.off': it breaks off" counts.off $stream
  refuses_at_once "'endless.xyz': line 1 never ends" endless.xyz $stream
  accepts many.ply $stream
  check "rows without bytes" one_line out "points 1,"
done
rm endless.xyz

# Every beginning of a good file, and it with any byte changed: an answer, not a crash.
head -c 150 cloud.xyz > small.xyz
printf "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n" > small.off
for file in small.xyz small.off list.ply; do
  ending=${file##*.}
  for size in 1 3 4 9 14 20 27 33; do
    head -c $size $file > "cut.$ending"
    run "cut.$ending" --quiet
    check "the first $size bytes of $file: an answer, not $code" test "$code" -le 1
  done
done

# A pipe holds points as a file does, but not twice.
mkfifo pipe.xyz
cat cloud.xyz > pipe.xyz &
accepts pipe.xyz
check "points from a pipe" one_line out "points 600,"
cat cloud.xyz > pipe.xyz &
accepts pipe.xyz --stream --box -2 -2 -1 2 2 13
check "points streamed from a pipe" one_line out "points 600,"
refuses "'pipe.xyz' cannot be read twice: give --box" pipe.xyz --stream
rm pipe.xyz
accepts_input() { # accepts_input FILE ARGUMENT...
  file=$1
  shift
  code=0
  "$program" "$@" < "$file" > out 2> err || code=$?
  check "$file as standard input, $*: exit code 0" test "$code" = 0
  check "$file as standard input, $*: its points" one_line out "points"
}
accepts_input cloud.xyz - --format xyz
accepts_input cloud.xyz --format .TXT -
accepts_input small.off -
code=0
"$program" - < cloud.xyz > out 2> err || code=$?
check "standard input without a format" one_line err "standard input: give --format"
refuses "no format" cloud.xyz --format exe

# Rows of numbers as people have them.
awk '{ print $1 ";" $2 ";" $3 }' cloud.xyz > semicolon.csv
awk '{ print $1 "," $2 "," $3 }' cloud.xyz > comma.csv
awk '{ print $1 "\t" $2 "\t" $3 }' cloud.xyz > tab.txt
awk '{ print $1 ", " $2 ", " $3 }' cloud.xyz > comma_blank.txt
awk '{ gsub(/\./, ","); print $1 ";" $2 ";" $3 }' cloud.xyz > decimal_comma.csv
{ echo 'x y z'; cat cloud.xyz; } > header.xyz
{ echo '//X Y Z'; cat cloud.xyz; } > cloud_compare.asc
{ echo '"id";"X [m]";"Y [m]";"Z [m]"'; awk '{ print NR ";" $1 ";" $2 ";" $3 }' cloud.xyz; } > named.csv
{ printf '\357\273\277'; cat cloud.xyz; } > mark.xyz
{ echo 600; awk '{ print $0, 17, 255, 0, 0 }' cloud.xyz; } > leica.pts
awk '{ print $0, 0, 0, 1 }' cloud.xyz > normals.pwn
sed 's/^/  +/; s/+-/-/' cloud.xyz > plus.xyz
sed 's/$/\r/' cloud.xyz > crlf.txt
accepts cloud.xyz --quiet -o expected.ply
for file in semicolon.csv comma.csv tab.txt comma_blank.txt decimal_comma.csv header.xyz \
  cloud_compare.asc named.csv mark.xyz leica.pts normals.pwn plus.xyz crlf.txt; do
  accepts "$file" --quiet -o found.ply
  check "$file has the same points" cmp expected.ply found.ply
  accepts "$file" --quiet --stream -o found.ply
  check "$file has the same points, streamed" cmp expected.ply found.ply
done
printf '1.5 2.5\n1 2 3\n' > two.xyz
printf '5\n0 0 0\n1 0 0\n' > fewer.pts
printf 'a b c\n1 2 3\n' > nameless.xyz
refuses "'two.xyz': line 1 is neither a row of at least three numbers" two.xyz
refuses "'fewer.pts': line 3 is the last, but more is expected" fewer.pts
refuses "'nameless.xyz': line 1 is neither" nameless.xyz

# What is no point is named, or left out and counted.
{ head -n 300 cloud.xyz; echo 'nan nan nan'; echo '1 2'; echo '1 2 inf'; tail -n 300 cloud.xyz; } > holes.xyz
refuses "'holes.xyz': line 301: point 300 is not finite; --skip-invalid" holes.xyz
for stream in '' --stream; do
  accepts holes.xyz --skip-invalid $stream
  check "what is left out is counted" one_line out "points 600, skipped 3,"
  accepts holes.xyz --skip-invalid --stats $stream
  check "what is left out is counted" one_line out '"points":600,"skipped":3,'
  accepts holes.xyz --skip-invalid --quiet -o found.ply $stream
  check "the rest is as it was" cmp expected.ply found.ply
done
printf 'OFF\n5 2 0\nnan 0 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 1 2 3\n3 0 3 4\n' > hole.off
accepts hole.off --skip-invalid --sample 50
check "a face without a corner is left out" one_line out "points 50, skipped 1,"
printf 'nan nan nan\n' > nothing.xyz
refuses "there are no points in it; 1 rows are invalid" nothing.xyz --skip-invalid

# Points far away are outliers, and change nothing else.
awk 'BEGIN { for(i = 0; i < 3000; ++i) printf "%.9g %.9g %.9g\n", cos(i * 2.4), sin(i * 2.4), i / 300 }' \
  > near.xyz
{ echo '1e9 -1e9 0'; head -n 1500 near.xyz; echo 0 700 0; tail -n 1500 near.xyz; echo 0 0 1e300; } > far.xyz
accepts near.xyz --quiet -o near.ply
for stream in '' --stream; do
  accepts far.xyz $stream -o far.ply
  check "they are counted" one_line out "points 3003, outliers 3, "
  check "the skeleton is as without them" cmp near.ply far.ply
done
accepts far.xyz --stats
check "they are in the statistics" one_line out '"outliers":3,'

# Coordinates as large as numbers get.
awk 'BEGIN { for(i = 0; i < 2000; ++i) printf "%.17g %.17g 0\n", 1.7e308 * cos(i), 1.7e308 * sin(i) }' \
  > largest.xyz
accepts largest.xyz --quiet -o largest.ply
check "all vertices are finite" sh -c '! grep -E "inf|nan" largest.ply'

# A surface of any size has points.
for side in 1e100 1e-100 1e300 1e-300; do
  printf "OFF\n3 1 0\n0 0 0\n$side 0 0\n0 $side 0\n3 0 1 2\n" > side.off
  accepts side.off --sample 100
  check "100 points of side $side" one_line out "points 100,"
done
if [ "$(uname -m)" = x86_64 ]; then
  before=$(ls -A)
  code=0
  (ulimit -v 1000000; exec "$program" side.off --sample 2000000000) > out 2> err || code=$?
  check "no memory for so many: exit code 1, not $code" test "$code" = 1
  check "no memory for so many: says so" one_line err "not enough memory for 2000000000 points"
  code=0
  awk 'BEGIN { for(i = 0; i < 400000; ++i) print i, i % 7, i % 13 }' > many.xyz
  (ulimit -v 40000; exec "$program" many.xyz --threads 1) > out 2> err || code=$?
  check "no memory for the file: says so" one_line err "not enough memory"
fi
finish
