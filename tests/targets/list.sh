#!/bin/sh
# list.sh OUT CC .. OBJECTS THIN.a: links a program on the host and lists the C files whose objects it
# took from the archive.
set -eu
out=$1
shift
"$@" -Wl,-Map="$out.map" -o "$out.program"
sed -n 's!^[^ ]*/\(\(core\|hal\|ports/framebuffer\|tests/harness\|tests/oracle\)/[a-z0-9_/]*\)\.o\( .*\)\{0,1\}$!\1.c!p' \
    "$out.map" | sort -u >"$out.new"
[ -s "$out.new" ] || { echo "$out: nothing was taken" >&2; exit 1; }
if cmp -s "$out.new" "$out"; then rm "$out.new"; else mv "$out.new" "$out"; fi
rm "$out.map" "$out.program"
