#!/bin/sh
# run_firmware.sh MACHINE ELF PLUGIN DIR REFERENCE: runs a bench firmware in DIR, leaves
# counts.txt there if its planes equal those in REFERENCE.
set -eu
machine=$1 elf=$(realpath "$2") plugin=$(realpath "$3") dir=$4 reference=$(realpath "$5")
rm -rf "$dir" && mkdir -p "$dir" && cd "$dir"
QEMU_AUDIO_DRV=none timeout 300 qemu-system-arm -M "$machine" -display none -monitor none \
    -serial none -semihosting-config enable=on,target=native -plugin "$plugin",out=counts.new \
    -kernel "$elf"
for plane in "$reference"/frame*; do
    cmp "$plane" "$(basename "$plane")" || { echo "$dir: wrong picture, no count" >&2; exit 1; }
done
mv counts.new counts.txt
