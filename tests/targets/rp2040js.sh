#!/bin/sh
# rp2040js.sh PANEL TURN RULE .. ELF: runs a firmware in rp2040js and writes what its panel shows.
# The package is in $BUILD/npm: `make deps` puts it there.
set -eu
for elf; do :; done
i=1
rules=
for word; do
    [ "$i" = $# ] || rules="$rules $word"
    i=$((i + 1))
done
arm-none-eabi-objcopy -O binary "$elf" "$elf.bin"
node tests/targets/rp2040js.mjs "$elf.bin" "$BUILD/npm/node_modules" >"$elf.trace"
"$BUILD/targets/glass" $rules <"$elf.trace"
rm "$elf.trace"
