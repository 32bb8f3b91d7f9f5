#!/bin/sh
# rp2040js.sh PANEL TURN RULE .. ELF: starts a firmware's UF2 image in rp2040js and writes what its panel shows.
# Without rules it shows what the firmware says instead.
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
python3 ports/rp2040/uf2.py "$elf.bin" "$elf.uf2" >&2
node tests/targets/rp2040js.mjs "$elf.uf2" "$BUILD/npm/node_modules" >"$elf.trace"
[ -z "$rules" ] || "$BUILD/targets/glass" $rules <"$elf.trace"
rm "$elf.trace"
