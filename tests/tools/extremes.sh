#!/bin/sh
# Every row of tests/EXTREMES.md names a suite and tests that it runs, and every test of the suites called
# extremes_* stands in a row.
set -u
page=tests/EXTREMES.md
passed=0 failed=0
rows=$(mktemp) && trap 'rm -f "$rows"' EXIT

check()
{
    if [ "$1" = 0 ]; then passed=$((passed + 1)); else
        echo "FAIL $page: $2"
        failed=$((failed + 1))
    fi
}

# "suite test", one a line
awk -F'|' '/^\| / && $2 !~ /^ what / { n = split($4, t, /[ ,]+/); gsub(/ /, "", $3)
    if ($3 == "" || $4 ~ /^ *$/) print "? ?"
    for (i = 1; i <= n; i++) if (t[i] != "") print $3, t[i] }' "$page" >"$rows"
[ "$(wc -l <"$rows")" -ge 20 ]
check $? "rows are missing"
while read -r suite test; do
    grep -q "^ *RUN($test);" "tests/unit/$suite.c" 2>/dev/null
    check $? "no test $suite/$test"
done <"$rows"
for file in tests/unit/extremes_*.c; do
    suite=$(basename "$file" .c)
    for test in $(sed -n 's/^ *RUN(\(.*\));/\1/p' "$file"); do
        grep -qx "$suite $test" "$rows"
        check $? "$suite/$test stands in no row"
    done
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
