#!/bin/sh
# Fuzzes every target for some time and keeps what covers more in the corpus.
# Usage: run.sh FOLDER_OF_PROGRAMS SECONDS [TARGET...]
set -eu
programs=$1 seconds=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
for target in ${*:-off ply xyz pcd las obj stl points}; do
  found=$(mktemp -d)
  echo "== $target"
  "$programs/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1000 \
    -malloc_limit_mb=200 -max_len=4096 -print_final_stats=1 -artifact_prefix="$PWD/$target-" \
    "$found" "$here/corpus/$target" 2>&1 | grep -E 'number_of_executed|ERROR|SUMMARY|Test unit|DONE' || true
  "$programs/fuzz_$target" -merge=1 "$here/corpus/$target" "$found" > /dev/null 2>&1 || true
  rm -r "$found"
done
