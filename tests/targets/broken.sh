#!/bin/sh
# broken.sh: proves that the comparison can fail. A frame as the host draws it passes, and fails when one bit
# of one pixel is another. What esp32-host sends passes as it is, and fails with two bytes exchanged, with a
# strip left out, and with a window one row too low.
set -eu
dir=$BUILD/targets/broken
passed=0
mkdir -p "$dir"

compare() { sh tests/targets/compare.sh broken "320 240" cat "$1" >"$dir/log"; }
accept() {
    compare "$1" || { cat "$dir/log"; exit 1; }
    passed=$((passed + 1))
}
refuse() { # SCENE FAULT
    if compare "$1"; then
        echo "FAIL: $2, and nothing was said"
        exit 1
    fi
    echo "$(grep 'broken .* FAIL' "$dir/log") as it must: $2"
    passed=$((passed + 1))
}
# What the panel shows after the trace that an awk program makes of esp32-host's.
show() {
    awk "$1" "$dir/trace" >"$dir/spoiled"
    "$BUILD/targets/glass" ili9341 1 byte=1 data.level=2:1 select.level=2:2 reset.level=2:4 \
        <"$dir/spoiled" >"$dir/shapes.elf" 2>"$dir/said" || cat "$dir/said"
}

"$BUILD/targets/reference" torus 320 240 >"$dir/torus.elf"
accept torus
printf '\377' | dd of="$dir/torus.elf" bs=1 seek=76800 conv=notrunc 2>/dev/null
refuse torus "a pixel changed"

"$BUILD/targets/esp32-host/shapes.elf" >"$dir/trace" 2>"$dir/said"
show '{ print }'
accept shapes
# "sent" counts the bytes since a pin changed: above 100 they are pixels. The first ten strips only
# clear the panel.
# shellcheck disable=SC2016
show '/0x2 / { sent = 0 } /0x1 / && ++sent > 101 && !done && $0 != held { print; done = 1; next }
      { if (NR > 1) print held; held = $0 } END { print held }'
refuse shapes "two bytes exchanged"
show '/0x2 / { strips += sent > 100; sent = 0 } /0x1 / && ++sent > 100 && strips == 14 { next } { print }'
refuse shapes "a strip left out"
# shellcheck disable=SC2016
show '/0x2 / { data = $4 ~ /[13579bdf]$/ } /0x1 / && !data { command = $4; n = 0 }
      /0x1 / && data && command == "0x2b" && ++n == 2 && $4 == "0x40" { $4 = "0x41" } { print }'
refuse shapes "a window one row too low"
echo "$passed passed, 0 failed"
