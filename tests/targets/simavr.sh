#!/bin/sh
# simavr.sh PANEL TURN RULE .. ELF: runs a firmware on an ATmega1284P and writes what its panel shows;
# without rules it shows what the firmware says instead.
set -eu
for elf; do :; done
i=1
rules=
for word; do
    [ "$i" = $# ] || rules="$rules $word"
    i=$((i + 1))
done
"$BUILD/targets/simavr" atmega1284p "$elf" >"$elf.trace"
[ -z "$rules" ] || "$BUILD/targets/glass" $rules <"$elf.trace"
rm "$elf.trace"
