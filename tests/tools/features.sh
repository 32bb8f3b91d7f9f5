#!/bin/sh
# The tables of core/README.md are true: every function is declared in a header of core, every file,
# suite of tests and picture exists, and no cell is empty.
set -u
page=core/README.md
passed=0 failed=0
rows=$(mktemp) && trap 'rm -f "$rows"' EXIT

check()
{
    if [ "$1" = 0 ]; then passed=$((passed + 1)); else
        echo "FAIL $page: $2"
        failed=$((failed + 1))
    fi
}

grep '^| ' "$page" | grep -v '^| what |\|^| function |' >"$rows"
[ "$(wc -l <"$rows")" -ge 60 ]
check $? "rows are missing"
! grep -q '|  *|' "$rows"
check $? "an empty cell"
for name in $(grep -o '`[a-zA-Z_0-9]*`' "$rows" | tr -d '`' | sort -u); do
    grep -rqw --include='*.h' "$name" core
    check $? "no function $name"
done
for file in $(grep -o '](\([^)]*\))' "$rows" | tr -d ']()' | sort -u); do
    [ -s "core/$file" ]
    check $? "no file $file"
done
for suite in $(awk -F'|' '{ print $5 }' "$rows" | tr ' ' '\n' | sort -u); do
    grep -q "void suite_$suite(void)" "tests/unit/$suite.c"
    check $? "no suite $suite"
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
