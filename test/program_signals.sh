#!/bin/sh
# Signals end the program at once, and leave no file. How long that takes is printed, not checked: on
# a busy machine it says nothing. Usage: program_signals.sh PROGRAM
. "$(dirname "$0")/program.sh"

# It would compute for hours, so that a signal is no race against the end of the work.
awk 'BEGIN { srand(1); for(i = 0; i < 60000; ++i) print rand(), rand(), rand() }' > large.xyz
mkfifo pipe.xyz
before=$(ls -A)

now() { # in milliseconds
  echo $(($(date +%s%N) / 1000000))
}

number_of() {
  case $1 in INT) echo 2 ;; TERM) echo 15 ;; esac
}

slowest=0
ends_by() { # ends_by SIGNAL DELAY ARGUMENT...: as if by that signal
  signal=$1 delay=$2
  shift 2
  "$program" "$@" > out 2> err &
  process=$!
  sleep "$delay"
  began=$(now)
  if ! kill -"$signal" $process 2> kill.log; then # a fast machine is done before
    rm kill.log *.ply written.xyz
    return 0
  fi
  rm kill.log
  code=0
  wait $process || code=$?
  took=$(($(now) - began))
  check "$signal after $delay s, $*: ended by it, not with code $code" \
    test "$code" = $((128 + $(number_of "$signal")))
  [ "$took" -le "$slowest" ] || slowest=$took
  check "$signal after $delay s, $*: no file" test "$before" = "$(ls -A)"
}
for signal in INT TERM; do
  for delay in 0.05 0.3 1; do
    ends_by $signal $delay large.xyz --as-published --iterations 1000000 -o interrupted.ply
  done
  sleep 1000 > pipe.xyz & # a pipe whose other end says nothing
  holder=$!
  ends_by $signal 0.3 pipe.xyz -o interrupted.ply
  kill $holder
  wait $holder 2> /dev/null || true
done

# While it reads, computes and writes much.
awk 'BEGIN { for(i = 0; i < 4000000; ++i) print i % 1000, i % 977, i % 31 }' > many.xyz
before=$(ls -A)
for delay in 0.2 0.5 1 1.5 2; do
  ends_by TERM $delay many.xyz --points written.xyz -o a.ply --threads 1
done
echo "slowest: $slowest ms"
finish
