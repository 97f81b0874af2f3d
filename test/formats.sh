#!/bin/sh
# Files of skeletons, read by other programs. Usage: formats.sh MADE_UP_SKELETON [--vtk]; the first is
# the program of that name
. "$(dirname "$0")/program.sh"

accepts s.polylines.txt s.obj s.ply s.vtp s.graphml s.swc s.dxf s.csv s.off s.tubes.ply
check "read by others" /usr/bin/python3 "$here/formats/check_formats.py" ${2-}
accepts S.PLY
check "the ending in capital letters" cmp s.ply S.PLY
finish
