#!/bin/sh
# run_callgrind.sh PROGRAM DIR TRUTH: counts the host program's instructions between the markers,
# leaves DIR/callgrind.out and counts.txt, one number. Its pictures must be those in TRUTH, all of
# them.
set -eu
program=$(realpath "$1")
scratch=$2/scratch truth=$3
rm -rf "$scratch" && mkdir -p "$scratch"
(cd "$scratch" && valgrind -q --tool=callgrind --toggle-collect=bench_counted \
    --dump-instr=yes --callgrind-out-file=../callgrind.out "$program" >../valgrind.log 2>&1)
for picture in "$truth"/frame*; do
    cmp "$picture" "$scratch/${picture##*/}"
done
rm -r "$scratch"
awk '$1 == "totals:" || $1 == "summary:" { n = $2 } END { print n }' "$2/callgrind.out" \
    >"$2/counts.txt"
