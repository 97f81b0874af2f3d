#!/bin/sh
# Checks that every call in wrong_calls.cpp gives one error, with the sentence that is written below it.
# Usage: wrong_calls.sh CMAKE BUILD_FOLDER
set -eu
source=$(dirname "$0")/wrong_calls.cpp
output=$(LC_ALL=C "$1" --build "$2" --target wrong_calls 2>&1) && {
  echo "the wrong calls compile"
  exit 1
}
expected=$(sed -n 's,^ *// expected: ,,p' "$source" | sort)
# What a compiler says of an assertion that fails: GCC 'error: static assertion failed: X', Clang
# 'error: static_assert failed due to requirement R "X"', or without quotes in newer ones.
errors=$(printf '%s\n' "$output" | sed -n 's/^.*[: ]error: *//p')
found=$(printf '%s\n' "$errors" |
        sed -n -e 's/^static[_ ]assert.*failed[^"]*"\(.*\)"$/\1/p' -e t \
            -e 's/^static assertion failed: //p' -e t \
            -e "s/^static assertion failed due to requirement .*': //p" -e t \
            -e 's/^/another error: /p' | sort)
[ "$found" = "$expected" ] || {
  printf 'expected these errors:\n%s\nbut found:\n%s\n' "$expected" "$found"
  exit 1
}
