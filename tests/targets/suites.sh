#!/bin/sh
# suites.sh OUT SUITE ..: writes the list of suites for a firmware, if it changed.
set -eu
out=$1
shift
{
    echo '/* Generated. */'
    echo '#include "tests/harness/harness.h"'
    for s; do echo "void suite_$s(void);"; done
    echo 'extern const struct test_suite test_suites[];'
    echo 'const struct test_suite test_suites[] = {'
    for s; do echo "    {\"$s\", suite_$s},"; done
    echo '    {0, 0}};'
} >"$out.new"
if cmp -s "$out.new" "$out"; then rm "$out.new"; else mv "$out.new" "$out"; fi
