#!/bin/sh
# Checks what .clang-tidy names, as errors. Usage: tidy.sh CLANG_TIDY BUILD_FOLDER FILE...
set -eu
cd "$(dirname "$0")/.."
tidy=$1 build=$2
shift 2
# The commands are GCC's: its default is C++17, and it has warnings of its own.
exec "$tidy" -p "$build" --quiet --extra-arg=-std=c++17 --extra-arg=-Wno-unknown-warning-option "$@"
