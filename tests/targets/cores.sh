#!/bin/sh
# cores.sh DIR SHOW: the torus of cores.c by one core of the RP2040 and by both: compares what the
# display shows with the host's frame, and what the busier of two cores executes with one alone.
set -u
dir=$1 show=$2
passed=0 failed=0
LIMIT=0.59
"$dir/reference" >"$dir/expected" || exit 2
for cores in 1 2; do
    # $show is a list of words
    $show "$dir/$cores.elf" >"$dir/$cores.565" 2>"$dir/$cores.log"
    hash=$(sha256sum "$dir/$cores.565" | cut -c1-16)
    if cmp -s "$dir/expected" "$dir/$cores.565"; then
        echo "rp2040-cores-$cores torus $hash ok"
        passed=$((passed + 1))
    else
        echo "rp2040-cores-$cores torus $hash FAIL"
        tail -3 "$dir/$cores.log"
        failed=$((failed + 1))
    fi
done
sed -n 's/^while GP.* high: \(.*\) instructions/\1/p' "$dir/1.log" "$dir/2.log" | tr '\n' ' ' |
    awk -v limit=$LIMIT '
    NF != 4 { print "FAIL: the frame of one core and that of two were not counted"; exit 1 }
    {
        busier = $3 > $4 ? $3 : $4
        printf "a frame of one core %d instructions, of two %d and %d: ", $1, $3, $4
        printf "the busier %.2f of one (at most %s)\n", busier / $1, limit
        exit busier > limit * $1
    }' || failed=$((failed + 1))
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
