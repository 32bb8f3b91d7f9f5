#!/bin/sh
# pack.sh TARGET BUILD LENGTH: of what the fuzzer found, inputs that reach what no other does, into tests/fuzz/corpus/TARGET.pack.
set -eu
target=$1 folder=$2/fuzzed
rm -rf "$folder/$target.least"
mkdir -p "$folder/$target.least"
"$folder/fuzz/fuzz-$target" -set_cover_merge=1 -use_value_profile=0 -max_len="$3" "$folder/$target.least" \
    "$folder/$target" >"$folder/$target.merge" 2>&1
# of all sizes, every so manieth, 100 KB in all
every=$(($(cat "$folder/$target.least"/* | wc -c) / 100000 + 1))
files=$(find "$folder/$target.least" -type f -printf '%s %p\n' | sort -n | cut -d' ' -f2 |
    awk -v every="$every" 'NR % every == 0')
mkdir -p tests/fuzz/corpus
# shellcheck disable=SC2086
"$2/fuzz/replay-$target" "tests/fuzz/corpus/$target.pack" - $files
echo "$target: $(echo "$files" | wc -l) inputs, $(wc -c <"tests/fuzz/corpus/$target.pack") bytes"
