#!/bin/sh
# The page of a skeleton in a browser. Usage: page.sh PROGRAM
. "$(dirname "$0")/program.sh"

# A tube of 400 000 points with a limb on its side.
awk 'BEGIN { srand(2); for(i = 0; i < 400000; ++i) { t = rand() * 6.2832; h = 10 * rand()
  if(i % 4) print cos(t), sin(t), h; else print 1 + h / 2, cos(t) / 2, 5 + sin(t) / 2 } }' > large.xyz
printf '1 2 3\n' > one.xyz
accepts large.xyz --quiet -o large.html
accepts one.xyz --quiet -o one.html
check "shown by a browser" /usr/bin/python3 "$here/page/check_page.py" large.html one.html
finish
