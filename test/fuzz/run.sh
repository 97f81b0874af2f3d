#!/bin/sh
# Fuzzes every target for some time, from the corpus on. What crashes is written to the current folder:
# put it into the corpus, under the name of what was wrong. What covers more is kept in the folder
# GROWN.
# Usage: run.sh FOLDER_OF_PROGRAMS SECONDS GROWN [TARGET...]
set -eu
programs=$1 seconds=$2 grown=$3
shift 3
here=$(cd "$(dirname "$0")" && pwd)
failures=0
for target in ${*:-off ply xyz pcd las obj stl points}; do
  mkdir -p "$grown/$target"
  echo "== $target"
  longest=4096
  [ "$target" != points ] || longest=400 # a skeleton takes longer than a file
  "$programs/fuzz_$target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=1000 \
    -malloc_limit_mb=200 -max_len=$longest -print_final_stats=1 -artifact_prefix="$PWD/$target-" \
    "$grown/$target" "$here/corpus/$target" > fuzz.log 2>&1 || failures=$((failures + 1))
  grep -E 'number_of_executed|ERROR|SUMMARY|Test unit|DONE' fuzz.log || true
done
echo "$failures targets failed"
[ "$failures" = 0 ]
