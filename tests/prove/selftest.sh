#!/bin/sh
# selftest.sh BUILD: what does not hold must not be proved. Each line breaks core, or what a proof takes as
# input, and names the property that must stay open then.
#       broken FILE SED PROOF PROPERTY
failed=0 passed=0
broken() {
    rm -rf "$build/broken"
    mkdir -p "$build/broken/tests"
    cp -r core "$build/broken/" && cp -r tests/prove "$build/broken/tests/"
    sed "$2" "$1" >"$build/broken/$1"
    cmp -s "$1" "$build/broken/$1" && { echo "selftest: nothing to break in $1: $2"; exit 1; }
    (cd "$build/broken" && PROVE="tests/prove/$3.c" TIMEOUT=4 sh tests/prove/prove.sh out) \
        >"$build/selftest.log" 2>&1
    if grep -q "$4.* is not proved" "$build/selftest.log"; then
        passed=$((passed + 1))
    else
        echo "selftest: $3 proves $1 with $2"
        failed=$((failed + 1))
    fi
}
# unbounded FILE SED PROOF: likewise for what gappa proves
unbounded() {
    sed "$2" "$1" >"$build/broken/$1"
    cmp -s "$1" "$build/broken/$1" && { echo "selftest: nothing to break in $1: $2"; exit 1; }
    if (cd "$build/broken" && PROVE="tests/prove/$3.gappa" sh tests/prove/rounding.sh out) \
        >"$build/selftest.log" 2>&1; then
        echo "selftest: $3 proves $1 with $2"
        failed=$((failed + 1))
    else
        passed=$((passed + 1))
    fi
}
build=$1
broken core/base/fixed.h 's/+ 32768) >> 16/+ 32768) * 65536/' fixed etch_q16_mul
broken core/base/trig.c 's/square_q28) >> 28/square_q28 * 16) >> 28/' trig bracket
broken core/base/divide.c 's/r.quotient += bit/r.quotient += 2 * bit/' divide etch_divide_u64
broken core/base/divide.c 's/d < n && d < UINT64_C(1) << 63/d < n/' divide etch_divide_u64
broken core/raster/edge.h 's/dy < INT32_C(1) << 22/dy < INT32_C(1) << 23/' edge edge_place
broken core/raster/edge.h 's/g->e += g->dy, g->x++/g->e += g->dy/' edge edge_step
broken tests/prove/plane.c 's/UINT64_C(1) << 48/UINT64_C(1) << 63/' plane etch_plane_setup
broken core/raster/plane.c 's/while (t.rest >= d)/while (t.rest > d)/' plane times_rest
unbounded core/vertex/reciprocal.h 's/185043/184543/' reciprocal
unbounded core/vertex/reciprocal.h 's/r >> 2/r >> 4/' reciprocal
unbounded core/base/texture.h 's/e >> 15) >> 17/e >> 15) >> 16/' reciprocal_q62
echo "$passed broken sources not proved, $failed proved"
[ "$failed" -eq 0 ]
