#!/bin/sh
# selftest.sh GRAPHS: that stack.py fails where it should: a frame over its budget, a name that fits
# no function, a pointer that nothing stands behind.
must_fail() {
    echo "$2" >"$graphs.budgets"
    if python3 tests/stack/stack.py "$graphs" "$graphs.budgets" "$graphs.table" >"$graphs.log" 2>&1; then
        echo "stack.py accepts $1"
        exit 1
    fi
}
graphs=$1
must_fail "a function over its budget" "4096 alone *
40 etch_rect_fill"
must_fail "a function over its own budget" "4096 alone *
20 alone etch_rect_fill"
must_fail "a function without a budget" "4096 alone etch_rect_*"
must_fail "a name that fits nothing" "4096 alone *
512 etch_no_such_function"
must_fail "a pointer with nothing behind it" "4096 alone *
512 kernel=etch_no_such_kernel etch_circle_fill"
