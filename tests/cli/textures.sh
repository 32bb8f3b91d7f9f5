# tests/cli: textures: their files. Sourced by run.

scene '2: texel 1: "xx" is not' 'scene 8 8\ntexture 2 1 00000000 xx\n'
scene '2: texel is missing' 'scene 8 8\ntexture 32767 32767 00000000\n'

# PPM files: what is legal is taken, anything else is an error of the scene's line.
scene '3: cannot open none.ppm: No such file' 'scene 8 8\n\ntexture ppm none.ppm\n'
scene '2: cannot open ./: ' 'scene 8 8\ntexture ppm ./\n'
scene '2: file is missing' 'scene 8 8\ntexture ppm\n'
ppm() { # MESSAGE CONTENT: a picture that is wrong with MESSAGE
    printf "$2" >"$out/wrong.ppm"
    scene "2: wrong.ppm $1" 'scene 8 8\ntexture ppm wrong.ppm\n'
}
ppm 'is not a binary PPM' ''
ppm 'is not a binary PPM' 'P'
ppm 'is not a binary PPM' 'P3 1 1 255\n0 0 0\n'
ppm 'is not a binary PPM' 'P61 1 255\nabc'
ppm 'is not a binary PPM' ' P6 1 1 255\nabc'
ppm 'has a header' 'P6 1'
ppm 'has a header' 'P6 1 1 255'
ppm 'has a header' 'P6 -1 1 255\nabc'
ppm 'has a header' 'P6 1 1 255abc'
ppm 'has a header' 'P6 1 x 255\nabc'
ppm 'has a header' 'P6 1 1 # 255'
ppm 'has a side' 'P6 0 1 255\n'
ppm 'has a side' 'P6 1 32768 255\nabc'
ppm 'has a side' 'P6 4294967297 1 255\nabc'
ppm 'has a side' 'P6 100000000000000000000 1 255\nabc'
ppm 'has a maxval' 'P6 1 1 254\nabc'
ppm 'has a maxval' 'P6 1 1 0\nabc'
ppm 'has a maxval' 'P6 1 1 65535\nabcdef'
ppm 'has 0 bytes of pixels, fewer than 1 x 1 x 3' 'P6 1 1 255\n'
ppm 'has 5 bytes of pixels, fewer than 2 x 1 x 3' 'P6 2 1 255\nabcde'
ppm 'has 7 bytes of pixels, more than 2 x 1 x 3' 'P6 2 1 255\nabcdef\n'
ppm 'has 4 bytes of pixels, more than' 'P6 1 1 255\r\nabc'
ppm 'has 17 bytes of pixels, more than' 'P6 1 1 255\nabcP6 1 1 255\nabc'

# The same four texels, by all the ways to write them, repeat over the frame from (-1, -1) on; alpha
# changes nothing.
t='255 255 255 255' # a vertex' colour
over="tri 0 0 0 1 $t -1 -1  9 0 0 1 $t 8 -1  0 9 0 1 $t -1 8" # one texel a pixel
texels='FF0000FF 00FF0000 0000FF80 FFffFf01'
checked='ffff1f00ffff''e00700f8e007'
pixels='\377\000\000\000\377\000\000\000\377\377\377\377'
tex='scene 3 2\nstate tex replace\n'
draws 'a texture' "${tex}texture 2 2 $texels\n$over\n" "$checked"
for state in 'persp 0' 'mode fast' 'ztest less' 'persp 0\nstate ztest equal\ncleardepth 0' \
    'persp 0\nstate mode fast' 'shade flat'; do
    draws "a texture, $state" "${tex}texture 2 2 $texels\nstate $state\n$over\n" "$checked"
done
printf 'P6 2 2 255\n'"$pixels" >"$out/t.ppm"
draws 'the latest texture counts' \
    "${tex}texture 1 1 01020304\ntexture ppm t.ppm\n$over\ntexture 1 1 01020304\n" "$checked"
draws 'two textures' "scene 3 1\nstate tex replace\ntexture 2 2 $texels\n$over
texture 1 1 00ff00ff\nstate scissor 1 0 1 1\n$over\n" 'ffffe007ffff'
legal() { # WHAT HEADER
    printf "$2$pixels" >"$out/t.ppm"
    draws "ppm: $1" "${tex}texture ppm t.ppm\n$over\n" "$checked"
}
legal 'blanks' 'P6\t2\v2\f\r\n255 '
legal 'comments' 'P6#\n# 9 9\n 2 # #\n#2\n#\r 2\n\n#\n255\n'
legal 'a comment in each place' 'P6 # P3\n2#\n2#\n255#\n'
legal 'leading zeros' 'P6 0000000000002 02 00255 '
rm "$out/t.ppm"
for text in "format rgb565_swapped\ntexture 2 2 $texels\n$over\n" \
    "texture 2 2 $texels\n$over\nformat rgb565_swapped\n"; do
    draws 'a texture, swapped' "$tex$text" "$checked"
done

# In perspective: w = 1 .. 4 from left to right, u = 0 .. 16. The numbers are computed here: u/w and
# 1/w are linear; or u is, between the ends of a block of 16 pixels, or everywhere.
ramp='texture 16 1'
for i in 0 1 2 3 4 5 6 7 8 9 a b c d e f; do
    ramp="$ramp 0000$(printf %02x $((0x$i * 8 + 4)))FF" # blue i of 31
done
wide="tri 0 -80 0 1 $t 0 0  0 80 0 1 $t 0 0  16 0 0 4 $t 16 0"
texel() { # FORMULA of u by c = 0 .. 1: the dump
    awk "function u(c) { return 4 * c / (1 - 0.75 * c) }
         BEGIN { for (x = 0; x < 16; x++) { c = (x + 0.5) / 16; printf \"%02x00\", int($1) } }"
}
tex='scene 16 1\nstate tex replace\n'
draws 'perspective' "$tex$ramp\n$wide\n" "$(texel 'u(c)')"
draws 'no perspective' "$tex$ramp\nstate persp 0\n$wide\n" "$(texel '16 * c')"
# Its 1/w falls slowly enough for blocks, its u/w fast enough to show them.
long="tri 0 -80 0 1 $t 0 0  0 80 0 1 $t 0 0  48 0 0 2 $t 512 0"
along() { # FORMULA of u by p(x)
    awk "function p(x) { c = (x + 0.5) / 48; return 256 * c / (1 - 0.5 * c) }
         BEGIN { for (x = 0; x < 16; x++) printf \"%02x00\", int($1) % 16 }"
}
draws 'blocks of 16' "$tex$ramp\nstate mode fast\n$long\n" "$(along 'p(0) + x * (p(16) - p(0)) / 16')"
draws 'blocks of 8' "$tex$ramp\nstate mode fast8\n$long\n" \
    "$(along 'x < 8 ? p(0) + x * (p(8) - p(0)) / 8 : p(8) + (x - 8) * (p(16) - p(8)) / 8')"
draws 'blocks of 16, precise' "$tex$ramp\n$long\n" "$(along 'p(x)')"
clip="-1 -5 0 1 $t 0 0  -1 5 0 1 $t 0 0  4 0 0 4 $t 16 0"
draws 'a ctri' "$tex$ramp\nctri $clip\n" "$(texel 'u(c)')"
draws 'a ctri, seen from behind' "scene 1 1\nstate tex replace\nstate cull back\n$ramp\nctri $clip\n" \
    0000
sim "$out/right.scene" --stats >"$out/stdout" || fail 'stats of a texture'
printf "$tex$ramp\n$wide\nstate persp 0\n$wide\nstate mode fast\nstate persp 1\n$wide\n" >"$out/right.scene"
sim "$out/right.scene" --stats >"$out/stdout" && grep -q -x 'pixels     48' "$out/stdout" &&
    grep -q -x 'triangles  3' "$out/stdout" && pass || fail "stats: $(cat "$out/stdout")"

# Every depth test and write with a texture, as without (statements.sh).
texture_depth() {
    text='scene 3 1\ncleardepth 100\ntexture 1 1 FF0000FF\nstate tex replace\n'
    text="${text}state persp $3\nstate ztest $1\nstate zwrite $2\n"
    for x in 0 1 2; do
        z="$((99 + x))"
        text="${text}state scissor $x 0 1 1\ntri 0 -9 $z 1 $t 0 0  0 9 $z 1 $t 0 0  9 0 $z 2 $t 0 0\n"
    done
    draws "texture: ztest $1 zwrite $2 persp $3" "$text" "$4"
    sim "$out/right.scene" --depth "$out/o.z16" &&
        depths=$(od -An -v -tu1 "$out/o.z16" | tr -s ' ' | sed 's/^ //; s/ 0//g')
    if [ "$depths" = "$5" ]; then pass; else fail "texture: ztest $1 zwrite $2: $depths"; fi
}
for persp in 0 1; do
    texture_depth never 1 $persp 000000000000 '100 100 100'
    texture_depth less 1 $persp 00f800000000 '99 100 100'
    texture_depth less 0 $persp 00f800000000 '100 100 100'
    texture_depth equal 1 $persp 000000f80000 '100 100 100'
    texture_depth lequal 1 $persp 00f800f80000 '99 100 100'
    texture_depth lequal 0 $persp 00f800f80000 '100 100 100'
    texture_depth greater 1 $persp 0000000000f8 '100 100 101'
    texture_depth greater 0 $persp 0000000000f8 '100 100 100'
    texture_depth notequal 1 $persp 00f8000000f8 '99 100 101'
    texture_depth gequal 1 $persp 000000f800f8 '100 100 101'
    texture_depth always 1 $persp 00f800f800f8 '99 100 101'
    texture_depth always 0 $persp 00f800f800f8 '100 100 100'
    texture_depth off 1 $persp 00f800f800f8 '100 100 100'
done

# What no fused kernel draws is drawn by stages.
bar='texture 3 1 FF0000FF 00FF00FF 0000FFFF'
row='scene 3 1\nstate tex replace\n'
draws 'a texture of 3 x 1' "$row$bar\n$over\n" 1f0000f8e007
draws 'a texture clamped' "${row}state wrap clamp\n$bar\n$over\n" 00f800f8e007
draws 'a texture mirrored' "${row}state wrap mirror\n$bar\n$over\n" 00f800f8e007
draws 'a texture filtered, texel on pixel' "${row}state filter linear\n$bar\n$over\n" 1f0000f8e007
draws 'a texture under white' "scene 3 1\nstate tex modulate\n$bar\n$over\n" 1f0000f8e007
draws 'a texture as a decal' "scene 3 1\nstate tex decal\n$bar\n$over\n" 1f0000f8e007
scene '4: each of "state mode exact", "dither on"' \
    "scene 8 8\nstate mode exact\nstate tex replace\n$wide\n"
draws 'fast where there is no faster kernel' \
    "scene 1 1\nstate tex replace\n$ramp\nstate mode fast\nstate ztest greater\n$wide\n" 0000
scene '3: "state tex" is on, but there is no texture' "scene 8 8\nstate tex replace\n$wide\n"
head -c 196608 /dev/zero >"$out/zeros"
{ printf 'P6 8192 8 255\n' && cat "$out/zeros"; } >"$out/wide.ppm"
draws 'a texture of 8192 x 8' \
    "scene 1 1\nclear 255 255 255\nstate tex replace\ntexture ppm wide.ppm\n$over\n" 0000
{ printf 'P6 2 32768 255\n' && cat "$out/zeros"; } >"$out/wide.ppm"
scene '2: wide.ppm has a side' 'scene 8 8\ntexture ppm wide.ppm\n'
rm "$out/zeros" "$out/wide.ppm"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$out/right.obj"
scene '4: "state tex" needs a mesh with a vt' \
    "scene 8 8\nstate tex replace\n$ramp\nmesh right.obj\n"
for z in '-3 1' '1.5 1' '0 0'; do
    draws 'a textured ctri that is clipped' "scene 2 1\nclear 255 255 255\nstate tex replace\n$(
        )texture 1 1 0000FFFF\nctri -9 -9 $z $t 0 0  9 -9 0 9 $t 0 0  0 9 0 9 $t 0 0\n" 1f00ffff
done
outside="2 0 0 1 $t 0 0  3 0 0 1 $t 0 0  2 0 -9 1 $t 0 0"
draws 'a textured ctri outside' "scene 1 1\nstate tex replace\n$ramp\nctri $outside\n" 0000
draws 'a texture that is idle' "scene 1 1\ntexture 3 1 00000000 00000000 00000000\n$over\n" ffff
