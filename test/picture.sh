#!/bin/sh
# A picture of a skeleton. Usage: picture.sh PROGRAM
. "$(dirname "$0")/program.sh"

draw="/usr/bin/python3 $here/../examples/draw_skeleton.py"
accepts cloud.xyz --quiet -o a.ply
check "drawn" $draw a.ply cloud.xyz a.png --up y
check "a PNG file" grep -q PNG a.png
printf '0 0 0\n1 1 1\n' > two.xyz
accepts two.xyz --quiet -o two.ply
check "hardly anything, drawn" $draw two.ply two.xyz two.png
finish
