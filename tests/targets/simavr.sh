#!/bin/sh
# simavr.sh PANEL TURN RULE .. ELF: runs a firmware on an ATmega1284P and writes what its panel shows.
set -eu
for elf; do :; done
i=1
rules=
for word; do
    [ "$i" = $# ] || rules="$rules $word"
    i=$((i + 1))
done
"$BUILD/targets/simavr" atmega1284p "$elf" >"$elf.trace"
"$BUILD/targets/glass" $rules <"$elf.trace"
rm "$elf.trace"
