#!/bin/sh
# prove.sh BUILD: each tests/prove/NAME.c through Frama-C. RTE writes an assertion for each
# operation that could leave its type, divide by zero or miss memory; EVA proves what intervals show, WP
# with z3 the rest and the contracts of the functions that the file's first line names. What is not
# proved is printed; the tools' log stays in BUILD/NAME.log. See README.md for what that means.
build=$1
failed=0 passed=0
for tool in frama-c why3 z3; do
    command -v $tool >/dev/null || { echo "make prove needs $tool: make deps installs it"; failed=1; }
done
[ $failed -eq 0 ] || exit 1
mkdir -p "$build"
export WHY3CONFIG="$build/why3.conf"
case $build in /*) ;; *) WHY3CONFIG=$PWD/$WHY3CONFIG ;; esac
why3 config detect >"$build/why3.log" 2>&1 || { cat "$build/why3.log"; exit 1; }

# line NAME: what follows "NAME:" at the beginning of a line of $file
line() {
    sed -n "s/^[/ ][* ]* $1: //p" "$file" | head -n 1 | sed 's, *\*/$,,'
}

for file in ${PROVE:-tests/prove/*.c}; do
    name=$(basename "$file" .c)
    wp=$(line wp) flags=$(line flags) spec=$(line spec)
    rm -f "$build/$name.csv"
    # shellcheck disable=SC2086
    frama-c -c11 -machdep gcc_x86_32 -cpp-extra-args="-I. -U__GNUC__" -warn-unsigned-overflow \
        -warn-signed-downcast $flags -main prove "$file" -rte \
        -then -eva -eva-verbose 0 -eva-precision 3 -eva-auto-loop-unroll 64 -eva-min-loop-unroll 33 \
        -eva-use-spec etch_wrap_add,etch_wrap_sub,etch_wrap_mul,etch_wrap_scale${spec:+,$spec} \
        -then -wp ${wp:+-wp-fct $wp} -wp-prop=@lemma,@assert,@check,@ensures,@requires,@invariant,@variant,@assigns \
        -wp-prover z3 -wp-timeout ${TIMEOUT:-20} -wp-par 2 -wp-cache none \
        -then -report -report-csv "$build/$name.csv" >"$build/$name.log" 2>&1
    [ -s "$build/$name.csv" ] || { tail -n 5 "$build/$name.log"; failed=$((failed + 1)); continue; }
    awk -F'\t' -v name="$name" -v spec=",$spec," '
        NR == 1 || $1 ~ /FRAMAC_SHARE/ || $5 ~ /from clause|behavior|^assigns/ { next }
        $2 == "prove.h" && name != "wrap" { next } # the contracts of wrap..: proved by wrap.c
        $4 ~ /wrap/ && name != "wrap" { next }     # and they are meant to wrap
        index(spec, "," $4 ",") { next } # its contract is proved where it is not only assumed
        $6 ~ /[Dd]ead|Untried/ { next } # a function that this file does not call
        $6 == "Considered valid" { next }
        $6 == "Valid" { valid++; next }
        { open++; printf "%s/%s:%s %s: %s is not proved: %s\n", $1, $2, $3, $4, $5, $7 }
        END { print valid + 0, open + 0 >sum }' sum="$build/$name.sum" "$build/$name.csv"
    read -r valid open <"$build/$name.sum"
    [ "$valid" -gt 0 ] || open=$((open + 1)) # nothing to prove is no proof
    printf '%s: %s proved, %s open\n' "$name" "$valid" "$open"
    sed -n 's/^[/ ]\* \(proved\|assumed\): /    \1: /p; s/^ \*          /            /p; /\*\//q' "$file" | sed 's, \*/$,,'
    passed=$((passed + valid)) failed=$((failed + open))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
