#!/bin/sh
# What the README and the manual show is what there is: the code in the README is
# examples/simple_example.cpp below its licence, and the manual's section on constants names every
# option and no other. Usage: readme.sh
set -eu
cd "$(dirname "$0")/.."
example=$(sed '1,/^$/d' examples/simple_example.cpp)
shown=$(sed -n '/^```cpp$/,/^```$/p' README.md | sed '1d;$d')
[ "$example" = "$shown" ] || { echo "README.md shows other code than examples/simple_example.cpp"; exit 1; }

names() { # names PATTERN: what is in quotation marks of any kind in the matches, sorted
  grep -oE "$1" | grep -oE '[a-z_]+' | grep -v '^visit$' | sort -u
}
options=$(cat include/CGAL/Point_set_skeletonization_3/internal/*/*.h | names 'visit\("[a-z_]+"')
named=$(sed -n '/^## Constants/,/^## The published/p' doc/user_manual.md |
  sed '1,/^`quality sweep/d' | names '`[a-z_]+`')
[ -n "$options" ] || { echo "there are no options in the headers"; exit 1; }
[ "$options" = "$named" ] || {
  echo "named by the headers or by the manual's section on constants, but not by both:"
  printf '%s\n' "$options" "$named" | sort | uniq -u
  exit 1
}
