#!/bin/sh
# broken.sh: proves that the comparison can fail: a frame as the host draws it passes, and fails when one
# bit of one pixel is another.
set -eu
dir=$BUILD/targets/broken
mkdir -p "$dir"
"$BUILD/targets/reference" torus 320 240 >"$dir/torus.elf"
sh tests/targets/compare.sh broken "320 240" cat torus
printf '\377' | dd of="$dir/torus.elf" bs=1 seek=76800 conv=notrunc 2>/dev/null
if sh tests/targets/compare.sh broken "320 240" cat torus >"$dir/log"; then
    echo "FAIL: a pixel was changed and nothing was said"
    exit 1
fi
grep 'broken torus .* FAIL' "$dir/log"
echo "2 passed, 0 failed"
