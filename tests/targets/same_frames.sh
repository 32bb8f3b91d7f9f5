#!/bin/sh
# same_frames.sh HASHES ..: from what the boards' comparisons wrote, one line for each scene and kind of
# frame: on how many boards it was seen, which must all have the same hash.
set -u
cat "$@" | sort | uniq -c | awk '
    { key = $2 " " $3; kinds[key]++; boards[key] += $1; hash[key] = $4 }
    END {
        for (key in kinds) {
            print key, kinds[key] == 1 ? hash[key] " on " boards[key] " boards" : "FAIL: hashes differ"
            if (kinds[key] == 1) passed++; else failed++
        }
        print passed + 0 " passed, " failed + 0 " failed"
        exit failed + 0 != 0
    }'
