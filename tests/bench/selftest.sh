#!/bin/sh
# selftest.sh BENCH_DIR: proves that the bench can be believed. Run after `make bench W="8 11"`.
#  - a picture with pixels one step off is refused, for colour and for depth;
#  - counts do not depend on how QEMU cuts the code into blocks (-singlestep: one each);
#  - the cycle model gives what the manual says for a piece of code counted by hand.
set -eu
bench=$(realpath "$1")
model=$(realpath "$(dirname "$0")/model.S") script=$(realpath linker/mps2.ld)
scratch=$bench/selftest
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch"

fail() { echo "bench selftest: $1" >&2; exit 1; }

run() { # run ELF COUNTS [OPTION]
    QEMU_AUDIO_DRV=none timeout 300 qemu-system-arm -M mps2-an385 ${3:-} -display none \
        -monitor none -serial none -semihosting-config enable=on,target=native \
        -plugin "$bench"/plugin.so,out="$2" -kernel "$1"
    rm -f frame*
}
sum() { awk '{ n += $2; c += $4 } END { print n, c }' "$1"; }

for spoil in 8/frame0.565 11/frame0.z16 11/frame0.565; do
    n=${spoil%/*} plane=${spoil#*/}
    rm -rf copy && mkdir copy && cp "$bench/host-portable/w$n"/frame* copy
    # A row of 320 pixels, each one step of blue or depth off. Some 3 in 100 lie so near to a
    # half that both steps are within the bound of the contract.
    python3 - "copy/$plane" <<'END'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
for i in range(320 * 120, 320 * 121):
    data[2 * i] ^= 1
open(sys.argv[1], "wb").write(data)
END
    wrong=$("$bench/check" "$n" copy 2>&1 | awk '/pixels are wrong/ { print $2 }')
    [ "${wrong:-0}" -ge 300 ] || fail "W$n with a wrong $plane: ${wrong:-0} of 320 pixels noticed"
done

run "$bench/m0plus-portable/w8.elf" blocks.txt
run "$bench/m0plus-portable/w8.elf" single.txt -singlestep
[ "$(sum blocks.txt)" = "$(sum single.txt)" ] || fail "counts depend on the blocks"

arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb -nostdlib -T "$script" "$model" -o model.elf
run model.elf model.txt
[ "$(sum model.txt)" = "$(awk '/EXPECT/ { print $3, $4; exit }' "$model")" ] ||
    fail "model.S: instructions and cycles are $(sum model.txt)"
echo "bench selftest: wrong pictures refused, counts exact, cycle model as in the manual"
