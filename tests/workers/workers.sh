#!/bin/sh
# workers.sh PROGRAM DIR: what the busier of two workers executes, as a part of what one alone does,
# on a scene of 50,000 triangles; instructions inside draw_share, counted by callgrind for each
# thread. Fails above LIMIT. Beside it the time of ten frames, which depends on what else the
# machine does.
set -eu
LIMIT=0.59
FRAMES=4
program=$1 dir=$2
rm -rf "$dir" && mkdir -p "$dir"

# $1 workers: the instructions of each thread, most first
count()
{
    valgrind -q --tool=callgrind --separate-threads=yes --fair-sched=try \
        --toggle-collect=draw_share --callgrind-out-file="$dir/$1" "$program" "$1" "$FRAMES" \
        >"$dir/$1.log" 2>&1 || {
        cat "$dir/$1.log" >&2
        return 1
    }
    cat "$dir/$1"-* | awk '$1 == "totals:" && $2 > 0 { print $2 }' | sort -rn
}

alone=$(count 1)
two=$(count 2)
slow=$("$program" 1 10)
fast=$("$program" 2 10)
# shellcheck disable=SC2086
echo $alone $two "$slow" "$fast" | awk -v limit=$LIMIT -v frames=$FRAMES '
    NF != 5 { print "FAIL: not one thread and two were counted"; exit 1 }
    {
        printf "50000 triangles, instructions of %d frames: ", frames
        printf "one worker %d, two %d and %d\n", $1, $2, $3
        printf "the busier of two executes %.3f of one alone (at most %s)\n", $2 / $1, limit
        printf "wall clock of 10 frames: %.1f ms and %.1f ms, %.2f of one alone\n", $4 / 1000,
            $5 / 1000, $5 / $4
        exit !($2 / $1 <= limit)
    }'
