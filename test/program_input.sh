#!/bin/sh
# Input files, good and bad. Usage: program_input.sh PROGRAM
. "$(dirname "$0")/program.sh"

# A mesh of two triangles in a row of formats.
vertices='0 0 0\n1 0 0\n1 1 0\n0 1 0\n'
printf "OFF\n4 2 0\n${vertices}3 0 1 2\n3 0 2 3\n" > mesh.off
printf "COFF # colours\n# a comment\n4 0 0\n0 0 0 255 0 0 255\n1 0 0 1 2 3 4\n1 1 0 1 2 3 4\n0 1 0 1 2 3 4" \
  > colours.off
ply='element vertex 4\nproperty float x\nproperty float y\nproperty float z\n'
faces='element face 2\nproperty list uchar int vertex_indices\n'
printf "ply\nformat ascii 1.0\n${ply}${faces}end_header\n${vertices}3 0 1 2\n3 0 2 3\n" > mesh.ply
printf "ply\nformat ascii 1.0\n${ply}end_header\n${vertices}" > cloud.ply
one='\000\000\200\077' zero='\000\000\000\000'
binary_vertices="$zero$zero$zero$one$zero$zero$one$one$zero$zero$one$zero"
header='ply\nformat binary_little_endian 1.0\n'
printf "${header}${ply}end_header\n${binary_vertices}" > binary.ply
face='\003\000\000\000\000\001\000\000\000\002\000\000\000'
printf "${header}${ply}${faces}end_header\n${binary_vertices}${face}${face}" > binary_mesh.ply
sed 's/float/int/' mesh.ply > integers.ply
for file in mesh.off colours.off mesh.ply cloud.ply integers.ply binary.ply binary_mesh.ply; do
  accepts "$file"
  check "$file has four points" one_line out "points 4,"
done
printf '# with normals\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1' > normals.xyz
accepts normals.xyz
check "normals.xyz has four points" one_line out "points 4,"
for file in mesh.off mesh.ply binary_mesh.ply; do
  accepts "$file" --sample 50
  check "50 points from $file" one_line out "points 50,"
done

# Lines that end in CR LF, names and paths of all kinds.
printf "OFF\r\n4 2 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n3 0 1 2\r\n3 0 2 3\r\n" > crlf.off
printf "0 0 0\r\n\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n" > crlf.xyz
sed 's/$/\r/' mesh.ply > crlf.ply
mkdir 'größe 尺寸'
cp mesh.off 'größe 尺寸/Netz ñ.OFF'
for file in crlf.off crlf.xyz crlf.ply "$PWD/mesh.off" "./mesh.off" "größe 尺寸/Netz ñ.OFF"; do
  accepts "$file"
  check "$file has four points" one_line out "points 4,"
done

# Not there, or not what it says.
mkdir folder.off
: > empty.off
: > empty.ply
: > empty.xyz
head -c 3000 "$program" > garbage.xyz
printf 'To be or not to be\nthat is the question\n' > text.xyz
for ending in off ply; do cp text.xyz "text.$ending"; cp garbage.xyz "garbage.$ending"; done
cp mesh.off wrong.ply
cp mesh.off wrong.xyz
cp mesh.ply wrong.off
refuses "'none.off': there is no such file" none.off
refuses "'folder.off': it is a folder" folder.off
for ending in off ply xyz; do
  refuses "'empty.$ending'" "empty.$ending"
  refuses "'text.$ending': line 1" "text.$ending"
  refuses "'garbage.$ending'" "garbage.$ending"
done
cp cloud.xyz cloud
cp cloud.xyz cloud.doc
cp cloud.xyz cloud.stl
refuses "'cloud': its extension" cloud
refuses "'cloud.doc': its extension" cloud.doc
refuses "'cloud.stl': it breaks off or is damaged after 0 points" cloud.stl
refuses "'wrong.ply': by its content it is a .off" wrong.ply
refuses "'wrong.xyz': by its content it is a .off" wrong.xyz
refuses "'wrong.off': by its content it is a .ply" wrong.off

# Broken off.
head -n 4 mesh.off > short.off
head -n 7 mesh.off > short_faces.off
head -n 10 mesh.ply > short.ply
head -c $(($(wc -c < binary_mesh.ply) - 5)) binary_mesh.ply > short_binary.ply
head -c $(($(wc -c < binary.ply) - 5)) binary.ply > short_points.ply
printf '0 0 0\n1 1' > short.xyz
refuses "'short.off': line 4" short.off
refuses "'short_faces.off': line 7" short_faces.off
refuses "'short.ply': line 10" short.ply
refuses "'short_binary.ply': it breaks off or is damaged after 4 points" short_binary.ply
refuses "'short_points.ply': it breaks off or is damaged after 3 points" short_points.ply
refuses "'short.xyz': line 2" short.xyz

# Wrong inside.
printf '0 0 0\n1 2 3\n1 nan 2\n' > nan.xyz
printf '0 0 0\n1 2 3 4\n' > intensity.xyz
printf "OFF\n4 0 0\n0 0 0\n1 inf 0\n1 1 0\n0 1 0\n" > infinite.off
printf "OFF\n# four of them\n4 0 0\n0 0 0\n1 x 0\n1 1 0\n0 1 0\n" > letter.off
nan='\000\000\300\177'
printf "${header}${ply}end_header\n$zero$zero$zero$one$nan$zero$one$one$zero$zero$one$zero" > nan.ply
printf "ply\nformat ascii 1.0\n${ply}end_header\n0 0 0\n1 0 nan\n1 1 0\n0 1 0\n" > nan_text.ply
printf "OFF\n4 1 0\n${vertices}3 0 1 7\n" > index.off
printf "ply\nformat ascii 1.0\n${ply}element face 1\nproperty list uchar int vertex_indices\n" > index.ply
printf "end_header\n${vertices}3 0 1 7\n" >> index.ply
printf 'x y z\n1 0 0 0\n2 0 0 1\n' > row_names.txt # the first column of a row is not x
sed 's/ x/ u/' mesh.ply > no_x.ply
refuses "'nan.xyz': line 3" nan.xyz
refuses "'intensity.xyz': line 2 is neither" intensity.xyz
refuses "'row_names.txt': line 2 is neither a comment nor a row with as many columns as line 1" \
  row_names.txt
refuses "'infinite.off': line 4" infinite.off
refuses "'letter.off': line 5" letter.off
refuses "'nan.ply': point 1 is not finite" nan.ply
refuses "'nan_text.ply': line 9" nan_text.ply
refuses "'index.off': line 7" index.off
refuses "'index.ply': face 0" index.ply
refuses "'no_x.ply': its vertices" no_x.ply

# Point after point: the same skeleton, or the same complaint.
for file in mesh.ply cloud.ply binary.ply binary_mesh.ply normals.xyz crlf.xyz crlf.ply mesh.off \
  colours.off crlf.off; do
  accepts "$file" --stream
  check "$file streamed has four points" one_line out "points 4,"
done
accepts cloud.xyz --quiet -o at_once.ply
accepts cloud.xyz --quiet --stream -o streamed.ply
check "the same skeleton from a stream" cmp at_once.ply streamed.ply
accepts cloud.xyz --quiet --stream --box -2 -2 -1 2 2 13 -o boxed.ply
check "a larger box will do" test -s boxed.ply
refuses "'cloud.xyz': line 501: point 500 is outside the given box" \
  cloud.xyz --stream --box -2 -2 -1 2 2 9.9999
refuses "'binary.ply': point 2 is outside the given box" binary.ply --stream --box 0 0 0 1 0.5 1
refuses "'none.xyz': there is no such file" none.xyz --stream
for ending in ply xyz; do
  refuses "'empty.$ending'" "empty.$ending" --stream
  refuses "'text.$ending': line 1" "text.$ending" --stream
  refuses "'garbage.$ending'" "garbage.$ending" --stream
done
refuses "'wrong.xyz': by its content it is a .off" wrong.xyz --stream
refuses "'short.ply': line 10" short.ply --stream
refuses "'short_binary.ply': it breaks off or is damaged after 4 points" short_binary.ply --stream
refuses "'short_points.ply': it breaks off or is damaged after 3 points" short_points.ply --stream
refuses "'short.xyz': line 2" short.xyz --stream
refuses "'nan.xyz': line 3" nan.xyz --stream
refuses "'intensity.xyz': line 2 is neither" intensity.xyz --stream
refuses "'nan.ply': point 1 is not finite" nan.ply --stream
refuses "'nan_text.ply': line 9" nan_text.ply --stream
refuses "'no_x.ply': its vertices" no_x.ply --stream
printf '# nothing\n' > comment.xyz
refuses "'comment.xyz': there are no points" comment.xyz
refuses "'comment.xyz': there are no points" comment.xyz --stream

# Nothing to sample: a surface without area.
printf "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n" > flat.off
refuses "'flat.off'" flat.off --sample 10
finish
