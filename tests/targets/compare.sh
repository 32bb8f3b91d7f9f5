#!/bin/sh
# compare.sh BOARD "WIDTH HEIGHT" SHOW SCENE ..: runs each scene's firmware and compares what the
# display shows with the host's frame. A line for each: BOARD SCENE HASH ok|FAIL.
set -u
board=$1 frame=$2 show=$3
shift 3
dir=$BUILD/targets/$board
passed=0 failed=0
: >"$dir/hashes"
for scene; do
    "$BUILD/targets/reference" "$scene" $frame >"$dir/$scene.expected" || exit 2
    # $frame and $show are lists of words
    $show "$dir/$scene.elf" >"$dir/$scene.565" 2>"$dir/$scene.log"
    hash=$(sha256sum "$dir/$scene.565" | cut -c1-16)
    if cmp -s "$dir/$scene.expected" "$dir/$scene.565"; then
        echo "$board $scene $hash ok"
        echo "$scene $(echo "$frame" | tr ' ' x) $hash" >>"$dir/hashes"
        passed=$((passed + 1))
    else
        echo "$board $scene $hash FAIL"
        tail -3 "$dir/$scene.log"
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
