# Shared by the tests of the program; sourced with the program as $1.
# Every test runs in a folder of its own, which is removed again.
set -eu
program=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failures=0
checks=0

check() { # check DESCRIPTION COMMAND...: the command has to succeed
  checks=$((checks + 1))
  description=$1
  shift
  if ! "$@"; then
    failures=$((failures + 1))
    echo "FAILED: $description"
  fi
}

run() { # run ARGUMENT...: the exit code is in $code, the streams in the files out and err
  code=0
  "$program" "$@" > out 2> err || code=$?
}

one_line() { # one_line FILE TEXT...: the file is one line that contains every text
  file=$1
  shift
  [ "$(wc -l < "$file")" = 1 ] || { cat "$file"; return 1; }
  for text in "$@"; do
    grep -qF -- "$text" "$file" || { echo "no '$text' in:"; cat "$file"; return 1; }
  done
}

refuses() { # refuses TEXT ARGUMENT...: exit 1, nothing on out, one line with the text on err
  text=$1
  shift
  before=$(ls -A)
  run "$@"
  check "$*: exit code 1, not $code" test "$code" = 1
  check "$*: nothing on standard output" test ! -s out
  check "$*: says one line" one_line err "$text"
  check "$*: leaves no file" test "$before" = "$(ls -A)"
}

accepts() { # accepts ARGUMENT...: exit 0, nothing on err
  run "$@"
  check "$*: exit code 0, not $code" test "$code" = 0
  check "$*: nothing on standard error" test ! -s err
}

finish() {
  echo "$((checks - failures)) checks passed, $failures failed"
  [ "$failures" = 0 ]
}

# A helix of points: enough to skeletonise, quick.
points() { # points SEPARATOR
  awk -v s="$1" 'BEGIN { for(i = 0; i < 600; ++i)
    printf "%g%s%g%s%g\n", cos(i * 2.4) , s, sin(i * 2.4), s, i / 50 }'
}
touch out err
points ' ' > cloud.xyz
