#!/bin/sh
# qemu_trace.sh QEMU MACHINE PANEL TURN RULE .. ELF: runs a firmware until it ends and writes what
# its panel shows, from the register writes that QEMU logs; see glass.c.
set -eu
qemu=$1 machine=$2
shift 2
for elf; do :; done
log=$elf.trace
rm -f "$log" && mkfifo "$log"
trap 'rm -f "$log"' EXIT
QEMU_AUDIO_DRV=none timeout 120 "$qemu" -M "$machine" -display none -monitor none -serial null \
    -semihosting-config enable=on,target=native -kernel "$elf" \
    -trace memory_region_ops_write -D "$log" >&2 &
i=1
rules=
for word; do
    [ "$i" = $# ] || rules="$rules $word"
    i=$((i + 1))
done
"$BUILD/targets/glass" $rules <"$log"
wait $!
