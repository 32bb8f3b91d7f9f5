#!/bin/sh
# The table of throughput in ports/README.md, between <!-- throughput --> and <!-- /throughput -->.
#       throughput.sh check|update BUILD "ROW .."
# Compilers and core change, so that the check lets instructions differ by 5 %; bytes must be equal.
set -eu
build=$2
page=ports/README.md
table=$build/throughput.md
{
    echo "| board | CPU, MHz | instructions | cycles | drawing, ms | bytes | bus, MHz, fed by | bus, ms |" \
        "bound by | frames/s |"
    echo "|---|---|---|---|---|---|---|---|---|---|"
    # shellcheck disable=SC2086
    cat $3
} >"$table"
if [ "$1" = update ]; then
    python3 tests/bench/insert.py "$page" throughput "$table"
    cat "$table"
    exit
fi
sed -n '/^<!-- throughput -->/,/^<!-- .throughput -->/p' "$page" | awk -F '|' '
    NR == FNR { instructions[$2] = $4; bytes[$2] = $7; next }
    $2 ~ /`/ {
        off = $4 / instructions[$2] - 1
        if (!($2 in instructions) || off > 0.05 || off < -0.05 || bytes[$2] != $7) {
            print "FAIL" $2 "is no more what the table says; see make throughput"
            failed++
        } else
            passed++
        seen[$2] = 1
    }
    END {
        for (board in instructions)
            if (board ~ /`/ && !(board in seen)) {
                print "FAIL" board "was not measured"
                failed++
            }
        print passed + 0 " passed, " failed + 0 " failed"
        exit failed + 0 != 0
    }' "-" "$table"
