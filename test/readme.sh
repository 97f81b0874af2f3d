#!/bin/sh
# The code in the README is examples/simple_example.cpp below its licence. Usage: readme.sh
set -eu
cd "$(dirname "$0")/.."
example=$(sed '1,/^$/d' examples/simple_example.cpp)
shown=$(sed -n '/^```cpp$/,/^```$/p' README.md | sed '1d;$d')
[ "$example" = "$shown" ] || { echo "README.md shows other code than examples/simple_example.cpp"; exit 1; }
