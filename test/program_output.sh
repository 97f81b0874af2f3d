#!/bin/sh
# Output files, written completely or not at all. Usage: program_output.sh PROGRAM
. "$(dirname "$0")/program.sh"

accepts cloud.xyz --quiet -o a.ply -o a.obj --output a.polylines.txt
for file in a.ply a.obj a.polylines.txt; do check "$file is there" test -s "$file"; done
check "nothing else is there" test -z "$(ls -A | grep part)"
accepts -o b.ply --quiet cloud.xyz
check "the same again, bit by bit" cmp a.ply b.ply

mkdir 'Ergebnis ü'
accepts cloud.xyz --quiet -o 'Ergebnis ü/a.ply' -o "$PWD/Ergebnis ü/a.obj"
check "a folder with any name" cmp a.ply 'Ergebnis ü/a.ply'

printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' > mesh.off
accepts mesh.off --quiet --sample 80 --seed 5 --points sampled.xyz
accepts mesh.off --quiet --sample 80 --seed 5 --points again.xyz
accepts mesh.off --quiet --sample 80 --seed 6 --points other.xyz
check "80 points" test "$(wc -l < sampled.xyz)" = 80
check "the same seed, the same points" cmp sampled.xyz again.xyz
check "another seed, other points" sh -c '! cmp -s sampled.xyz other.xyz'

# Refused before anything is computed, even if only one of two is wrong.
mkdir folder.ply
refuses "'a.stl': name it" cloud.xyz -o c.ply -o a.stl
refuses "'a.txt': name it" cloud.xyz -o a.txt
refuses "'none/a.ply': there is no folder 'none'" cloud.xyz -o none/a.ply
refuses "'folder.ply': it is a folder" cloud.xyz -o folder.ply
refuses "given twice" cloud.xyz -o c.ply -o c.ply
refuses "'./c.ply': this output is given twice" cloud.xyz -o c.ply -o ./c.ply
ln -s c.ply link_to_c.ply
refuses "given twice" cloud.xyz -o c.ply -o link_to_c.ply
rm link_to_c.ply
refuses "'c.ply': name it .xyz" cloud.xyz --points c.ply
refuses "'./cloud.xyz': it is the input" cloud.xyz --points ./cloud.xyz

# A disk that is full: no file may grow beyond 512 bytes. What was there before stays.
echo before > full.ply
before=$(ls -A)
code=0
(trap '' XFSZ; ulimit -f 1; "$program" cloud.xyz --quiet -o full.ply 2> err) || code=$?
check "a full disk: exit code 1, not $code" test "$code" = 1
check "a full disk: one line" one_line err "'full.ply'" "free space"
check "a full disk: the older file is still there" test "$(cat full.ply)" = before
check "a full disk: no other file" test "$before" = "$(ls -A)"

# All outputs, or none: the skeleton of one point fits on that disk, many points do not.
echo before > one.obj
awk 'BEGIN { for(i = 0; i < 600; ++i) print 7, 8, 9 }' > one.xyz
before=$(ls -A)
code=0
(trap '' XFSZ; ulimit -f 1; "$program" one.xyz --quiet -o one.obj -o one.polylines.txt --points p.xyz \
  2> err) || code=$?
check "a disk full late: exit code 1, not $code" test "$code" = 1
check "a disk full late: the first output is as it was" test "$(cat one.obj)" = before
check "a disk full late: no other file" test "$before" = "$(ls -A)"

# Other people's files: what only has a similar name, what a link leads to, what may not be changed.
echo mine > mine.ply.part
ln -s mine.ply.part b2.ply.part
accepts cloud.xyz --quiet -o mine.ply -o b2.ply
check "a file of the user's is untouched" test "$(cat mine.ply.part)" = mine
mkdir deep
echo before > deep/real.ply
ln -s deep/real.ply link.ply
ln -s real.obj deep/link.obj
accepts cloud.xyz --quiet -o link.ply -o deep/link.obj
check "a link stays a link" test -L link.ply -a -L deep/link.obj
check "what it leads to is written" cmp a.ply deep/real.ply
check "also what was not there" cmp a.obj deep/real.obj
echo before > mode.ply
chmod 640 mode.ply
accepts cloud.xyz --quiet -o mode.ply
check "the permissions stay" test "$(stat -c %a mode.ply)" = 640
(umask 027; "$program" cloud.xyz --quiet -o new.ply)
check "a new file has those of new files" test "$(stat -c %a new.ply)" = 640
if [ "$(id -u)" != 0 ]; then
  chmod 440 mode.ply
  refuses "'mode.ply': it is write-protected" cloud.xyz -o mode.ply
fi
mkfifo fifo.ply
refuses "'fifo.ply': it is no ordinary file" cloud.xyz -o fifo.ply
rm fifo.ply

# Two at once: whoever is last wins, and nothing is torn.
for i in 1 2 3 4 5 6 7 8; do "$program" cloud.xyz --quiet -o race.ply & done
wait
check "eight writers of a file" cmp a.ply race.ply
check "nothing is left over" test -z "$(ls -A | grep '^\.skeleton')"

# Ctrl-C while it computes, sent until it has an effect. The published method takes seconds here, so
# that the end of the work is no race against the signal on any machine.
awk 'BEGIN { srand(1); for(i = 0; i < 60000; ++i) print rand(), rand(), rand() }' > large.xyz
before=$(ls -A)
"$program" large.xyz --as-published -o interrupted.ply > out 2> err &
while kill -INT $! 2> kill.log; do sleep 0.1; done
code=0
wait $! || code=$?
rm kill.log
check "interrupted: it is no success" test "$code" != 0
check "interrupted: no file" test "$before" = "$(ls -A)"
finish
