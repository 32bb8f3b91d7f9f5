# tests/cli: accuracy modes and dithering. Read by run.

# Over three pixels from 127 to 128: the middle is 15.5 steps of red, which is a tie and goes up.
draws 'exact: a tie' "scene 2 1\nfrac 1\nstate mode exact\ntri 1 1 0 1 127 0 0 255 0 0  5 1 0 1 128 0 0 255 0 0  1 5 0 1 127 0 0 255 0 0\n" 00780080
draws 'exact, bytes swapped' "scene 2 1\nformat rgb565_swapped\nfrac 1\nstate mode exact\ntri 1 1 0 1 127 0 0 255 0 0  5 1 0 1 128 0 0 255 0 0  1 5 0 1 127 0 0 255 0 0\n" 00780080

# 62 of 255 is 7.54 steps of red: 8 where the threshold of row 0 is high, in every other column.
over='tri 0 0 9 1 62 0 0 255 0 0  20 0 9 1 62 0 0 255 0 0  0 20 9 1 62 0 0 255 0 0'
draws 'dithered, smooth' "scene 8 1\nstate dither on\n$over\n" 00380040003800400038004000380040
draws 'dithered, flat, nearer' \
    "scene 8 1\nstate shade flat\nstate ztest less\nstate dither on\n$over\n" \
    00380040003800400038004000380040
only='each of "state mode exact", "dither on"'
scene "5: $only" 'scene 8 8\nstate mode exact\nstate ztest greater\n\n'"$over\n"
scene "4: $only" 'scene 8 8\nstate mode exact\nstate blend add\n'"$over\n"
scene "4: $only" 'scene 8 8\nstate mode exact\nstate dither on\n'"$over\n"
scene "3: $only" 'scene 8 8\nstate dither on\ntri 0 0 0 1 1 0 0 255 0 0  8 0 0 2 2 0 0 255 0 0  0 8 0 3 3 0 0 255 0 0\n'
scene '2: ' 'scene 8 8\nstate dither maybe\n'
scene "6: $only" 'scene 8 8\nstate dither on\nstate depth inverse\nstate ztest less\n\n'"$over\n"
scene '2: ' 'scene 8 8\nstate depth float\n'

# One depth: 65535.0 - 40000 is 2^14 (1 + 1143.9 / 2048), so 65535 - (30 * 2048 + 1144) = 0x0B87, and
# what comes after it and is not nearer does not pass.
flat='0 0 40000 1 255 0 0 255 0 0  9 0 40000 1 255 0 0 255 0 0  0 9 40000 1 255 0 0 255 0 0'
printf "scene 1 1\nstate depth inverse\nstate ztest less\ntri $flat\nstate shade flat\ntri ${flat}\n" \
    >"$out/deep.scene"
if sim "$out/deep.scene" --depth "$out/o.z16" 2>"$out/stderr" &&
    [ "$(od -An -v -tx1 "$out/o.z16" | tr -d ' \n')" = 870b ]; then pass; else
    fail "inverse depth: $(od -An -v -tx1 "$out/o.z16")"
fi
rm -f "$out/o.z16"
