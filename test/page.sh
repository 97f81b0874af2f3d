#!/bin/sh
# The page of a skeleton in a browser. Usage: page.sh PROGRAM
. "$(dirname "$0")/program.sh"

# A tube of so many points with a limb on its side.
tube() {
  awk -v n="$1" 'BEGIN { srand(2); for(i = 0; i < n; ++i) { t = rand() * 6.2832; h = 10 * rand()
    if(i % 4) print cos(t), sin(t), h; else print 1 + h / 2, cos(t) / 2, 5 + sin(t) / 2 } }'
}
tube 20000 > tube.xyz
tube 400000 > large.xyz
printf '1 2 3\n' > one.xyz
accepts tube.xyz --quiet -o tube.html
accepts large.xyz --quiet -o large.html
accepts one.xyz --quiet -o one.html
check "shown by a browser" /usr/bin/python3 "$here/page/check_page.py" tube.html large.html \
  one.html
finish
