#!/bin/sh
# run_callgrind.sh PROGRAM DIR: counts the host program's instructions between the markers,
# leaves DIR/callgrind.out and counts.txt, one number.
set -eu
program=$(realpath "$1")
scratch=$2/scratch
rm -rf "$scratch" && mkdir -p "$scratch"
(cd "$scratch" && valgrind -q --tool=callgrind --toggle-collect=bench_counted \
    --dump-instr=yes --callgrind-out-file=../callgrind.out "$program" >../valgrind.log 2>&1)
cmp "$2/frame0.565" "$scratch/frame0.565"
rm -r "$scratch"
awk '$1 == "totals:" || $1 == "summary:" { n = $2 } END { print n }' "$2/callgrind.out" \
    >"$2/counts.txt"
