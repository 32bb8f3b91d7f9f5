#!/bin/sh
# Runs steps and sums what they report.
#       steps.sh DIRECTORY NAME COMMAND [NAME COMMAND] .. [-- NAME COMMAND ..]
# Shows each step's output, keeps it in DIRECTORY/NAME.log, and tells the seconds it took. A step
# that ends with a line "N passed, N failed" counts with those numbers, any other as one by its exit
# status; one that stops without reporting a failure of its own counts as one failed. Ends with the
# sum in the same form, so that steps nest, and fails if anything failed. Those after -- run at the
# same time, and are shown when the others are done.
dir=$1
shift
mkdir -p "$dir" || exit 1
passed=0 failed=0 bad=

# $1: the lines "N passed, N failed" of a log end with its sum: p and f
sum_of()
{
    sum=$(sed -n 's/^\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed$/\1 \2/p' "$1" | tail -n 1)
    p=${sum% *} f=${sum#* }
}

beside=
i=0
for word in "$@"; do
    i=$((i + 1))
    [ "$word" != -- ] || beside=$i
done
if [ -n "$beside" ]; then
    mkdir -p "$dir/beside" || exit 1
    (
        shift "$beside"
        sh "$0" "$dir/beside" "$@" >"$dir/beside.log" 2>&1
    ) &
fi

while [ $# -gt 0 ] && [ "$1" != -- ]; do
    name=$1 command=$2
    shift 2
    echo "== $name"
    begin=$(date +%s)
    { sh -c "$command" 2>&1; echo $? >"$dir/$name.status"; } | tee "$dir/$name.log"
    status=$(cat "$dir/$name.status")
    sum_of "$dir/$name.log"
    if [ -z "$sum" ]; then
        p=0 f=0
        [ "$status" -ne 0 ] || p=1
    fi
    [ "$status" -eq 0 ] || [ "$f" -gt 0 ] || f=1
    [ "$f" -eq 0 ] || bad="$bad $name"
    passed=$((passed + p)) failed=$((failed + f))
    echo "== $name: $(($(date +%s) - begin)) s"
done

if [ -n "$beside" ]; then
    wait
    cat "$dir/beside.log"
    sum_of "$dir/beside.log"
    [ -n "$sum" ] || p=0 f=1
    [ "$f" -eq 0 ] || bad="$bad beside"
    passed=$((passed + p)) failed=$((failed + f))
fi
[ -z "$bad" ] || echo "failed:$bad (logs in $dir)"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
