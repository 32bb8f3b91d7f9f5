#!/bin/sh
# Style and static analysis: clang-format, clang-tidy, cppcheck. A missing tool is a failure.
#       lint.sh BUILD FILE ..
# Left out: signed right shifts (base/fixed.h asserts that they are arithmetic), and guesses about
# uninitialized values, which both tools get wrong here; `make uninit` finds the real ones.
build=$1
shift
passed=0 failed=0
mkdir -p "$build/lint" || exit 1

# $1 name, the rest: the command; quiet if it succeeds
run()
{
    name=$1
    shift
    if "$@" >"$build/lint/$name.log" 2>&1; then
        echo "ok   $name"
        passed=$((passed + 1))
    else
        echo "FAIL $name"
        grep -E 'warning:|error:|not found|style|Conflict' "$build/lint/$name.log" | head -n 40
        failed=$((failed + 1))
    fi
}

sources=$(for file in "$@"; do case $file in *.c) echo "$file" ;; esac; done)
core=$(for file in $sources; do case $file in core/* | hal/*) echo "$file" ;; esac; done)

run clang-format clang-format --dry-run -Werror "$@"
# shellcheck disable=SC2086
run clang-tidy clang-tidy --quiet --warnings-as-errors='*' --checks="-*,bugprone-*,\
clang-analyzer-*,misc-*,readability-misleading-indentation,readability-redundant-*,\
readability-duplicate-include,readability-else-after-return,readability-non-const-parameter,\
-bugprone-easily-swappable-parameters,-bugprone-narrowing-conversions,-bugprone-macro-parentheses,\
-bugprone-implicit-widening-of-multiplication-result,-bugprone-reserved-identifier,\
-clang-analyzer-security.insecureAPI.*,-misc-unused-parameters,-misc-no-recursion,\
-misc-include-cleaner,-bugprone-branch-clone,-bugprone-signed-char-misuse,\
-bugprone-too-small-loop-variable,-clang-analyzer-core.UndefinedBinaryOperatorResult,\
-clang-analyzer-core.uninitialized.*" \
    $core -- -std=c11 -I. -ffreestanding
# shellcheck disable=SC2086
run cppcheck cppcheck --quiet --std=c11 --enable=warning,portability,performance \
    --error-exitcode=1 --inline-suppr --suppress=missingIncludeSystem -I. \
    --suppress=objectIndex --suppress=unusedStructMember \
    --suppress=shiftTooManyBitsSigned --suppress=uninitvar --suppress=ctuuninitvar \
    -D__GNUC__ $core
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
