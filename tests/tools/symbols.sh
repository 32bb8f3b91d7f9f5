#!/bin/sh
# What core and hal objects may contain, checked on the cores that they are for.
#       symbols.sh DIRECTORY [SOURCE] ..
# Compiles every source for Cortex-M0+, AVR and rv32imac at -Os and -O2 and looks at each object:
#   - every undefined name is one of etch's own, memcpy, memset, or a helper of libgcc that works
#     on integers of 32 bits (or multiplies, shifts, adds or compares 64): so no float helper, no
#     other libc name, no 64-bit divide;
#   - no byte of .data, .bss or common memory: no mutable state.
# Core must also be closed: an etch name that core uses is defined in core. The last line is
# "N passed, N failed", one for each object and for each core's closure.
dir=$1
shift
passed=0 failed=0
warn="-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Wmissing-prototypes
      -Wdouble-promotion -Werror -ffreestanding"

# Helpers of libgcc that are allowed, by core.
arm='__aeabi_(u?idiv(mod)?|lmul|llsl|llsr|lasr|u?lcmp)|__gnu_thumb1_case_[a-z]+|__clzsi2'
avr='__(u?mul(qi|hi|si|di)3|u?mulhisi3|usmulhisi3|mul[uso]hisi3|u?mulsidi3)'
avr="$avr|__u?divmod[qhs]i4|__(add|sub)di3(_s8)?|__u?cmpdi2(_s8)?|__negdi2"
avr="$avr|__(ashl|ashr|lshr|rotl)[hsd]i3|__prologue_saves__|__epilogue_restores__"
avr="$avr|__tablejump2?__|__tablejump_elpm__|__do_copy_data"
rv32='__(ashl|ashr|lshr)di3|__clz[sd]i2|__muldi3'

# Of the objects that file $1 lists, all at once: a line "OBJECT what is wrong" for every undefined name
# that is not allowed, and for memory that is not constant.
wrong()
{
    xargs "$nm" -A -u <"$1" | sed 's/^\([^:]*\):.* /\1 uses /' |
        grep -Evx "[^ ]+ uses (etch_[a-z0-9_]+|memcpy|memset|$allowed)"
    xargs "$nm" -A <"$1" | sed -n 's/^\([^:]*\):.* C \(.*\)/\1 has common memory: \2/p'
    xargs "$size" -A <"$1" | awk '$2 == ":" { object = $1 }
        $1 ~ /^\.(s?data|s?bss|tdata|tbss)/ && $1 !~ /^\.data\.rel\.ro/ && $2 > 0 {
            print object, "has bytes of mutable memory:", $1, $2 }'
}

# Names that core uses and nobody in core defines.
check_closure()
{
    find "$out/core" -name '*.o' -exec "$nm" -u {} + | awk '/ U / { print $NF }' | grep '^etch_' |
        sort -u >"$out/used"
    find "$out/core" -name '*.o' -exec "$nm" --defined-only {} + | awk 'NF == 3 { print $3 }' |
        sort -u >"$out/defined"
    open=$(comm -23 "$out/used" "$out/defined")
    [ -z "$open" ] || echo "FAIL $core $opt: core uses what it does not define:" $open
    [ -z "$open" ]
}

# $1 core, $2 tool prefix, $3 flags, $4 allowed helpers
check_core()
{
    core=$1 nm=${2}nm size=${2}size allowed=$4
    for opt in -Os -O2; do
        out=$dir/$core$opt n=0 broken=$failed
        rm -rf "$out"
        mkdir -p "$out"
        for source in $sources; do
            object=$out/${source%.c}.o
            mkdir -p "${object%/*}"
            # shellcheck disable=SC2086
            if "${2}gcc" $3 $opt $warn -c "$source" -o "$object"; then
                echo "$object"
                n=$((n + 1))
            else
                echo "FAIL $core $opt $source: does not compile" >&2
            fi
        done >"$out/objects"
        wrong "$out/objects" | sed "s,^$out/,FAIL $core $opt ," >"$out/wrong"
        cat "$out/wrong"
        bad=$(cut -d ' ' -f 4 "$out/wrong" | sort -u | wc -l)
        failed=$((failed + bad + $(echo $sources | wc -w) - n)) passed=$((passed + n - bad))
        if check_closure; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
        helpers=$(xargs "$nm" -u <"$out/objects" | awk '/ U / { print $NF }' |
            grep -v '^etch_' | sort -u | tr '\n' ' ')
        [ "$failed" -gt "$broken" ] || echo "$core $opt: $n objects, no byte of .data or .bss;" \
            "not etch's own: ${helpers:-none}"
    done
}

sources=$*
[ -n "$sources" ] || sources=$(find core hal ports/framebuffer -name '*.c' | sort)
check_core m0plus arm-none-eabi- "-mcpu=cortex-m0plus -mthumb" "$arm"
check_core avr avr- "-mmcu=atmega2560" "$avr"
check_core rv32imac riscv64-unknown-elf- "-march=rv32imac -mabi=ilp32" "$rv32"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
