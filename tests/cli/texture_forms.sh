# tests/cli: the forms of the texture statement, and the states of samplers. Sourced by run.

t='255 255 255 255' # a vertex' colour
quad() { # U V STEP: a texel every 1/STEP px, from (U, V) on, over a frame of 8 x 8
    echo "tri 0 0 0 1 $t $1 $2  8 0 0 1 $t $(($1 + 8 * $3)) $2  0 8 0 1 $t $1 $(($2 + 8 * $3))"
}
three='00f8''e007''1f00' # red, green, blue
tex='scene 3 1\nstate tex replace\n'
draws 'RRGGBB' "${tex}texture 3 1 FF0000 00ff00 0000FF\n$(quad 0 0 1)\n" $three
draws 'pal8' "${tex}texture pal8 3 1 3 0000FFff FF0000FF 00FF00FF 1 2 0\n$(quad 0 0 1)\n" $three
draws 'pal8, opaque' "${tex}texture pal8 3 1 3 0000FF FF0000 00FF00 1 2 0\n$(quad 0 0 1)\n" $three
for row in 0 1 2; do # rows of three 4-bit texels begin in either half of a byte
    indexes=$([ $row = 0 ] && echo '0 1 2 3 3 3 3 3 3' ||
        { [ $row = 1 ] && echo '3 3 3 0 1 2 3 3 3' || echo '3 3 3 3 3 3 0 1 2'; })
    draws "pal4, row $row" \
        "${tex}texture pal4 3 3 4 FF0000 00FF00 0000FF 000000 $indexes\n$(quad 0 $row 1)\n" $three
done
for i in 15 7; do
    many=$(printf '000000FF %.0s' 1 2 3 4 5 6 7)
    draws "pal4, colour $i" \
        "${tex}texture pal4 3 1 $((i + 1)) $many $([ $i = 15 ] && echo "$many 000000FF") FF0000FF $i $i $i
$(quad 0 0 1)\n" '00f800f800f8'
done
draws 'pal8, alpha' "${tex}clear 255 255 255\nstate blend alpha
texture pal8 3 1 3 FF000000 FF0000FF 00FF00FF 0 1 2\n$(quad 0 0 1)\n" 'ffff00f8e007'
draws 'pal4, alpha test' "${tex}clear 255 255 255\nstate atest 128
texture pal4 3 1 3 FF00007F FF000080 00FF00FF 0 1 2\n$(quad 0 0 1)\n" 'ffff00f8e007'
printf 'P6 3 1 255\n\377\000\000\000\377\000\000\000\377' >"$out/t.ppm"
printf 'P6 3 1 255\n\377\000\377\000\377\000\000\377\000' >"$out/m.ppm" # green: 0, 255, 255
draws 'ppm' "${tex}texture ppm t.ppm\n$(quad 0 0 1)\n" $three
draws 'ppm, masked' "${tex}clear 255 255 255\nstate blend alpha
texture ppm t.ppm mask m.ppm\n$(quad 0 0 1)\n" 'ffffe0071f00'
draws 'texels with alpha' "${tex}clear 255 255 255\nstate blend alpha
texture 3 1 FF000000 00FF00FF 0000FFFF\n$(quad 0 0 1)\n" 'ffffe0071f00'
for form in 'pal8 3 1 3 FF0000 00FF00 0000FF 0 1 2' '3 1 FF0000 00FF00 0000FF'; do
    draws 'swapped' "${tex}format rgb565_swapped\nstate wrap clamp\ntexture $form\n$(quad 0 0 1)\n" \
        $three
done

# Wraps, on three texels, from -2 on, in each axis.
r=00f8 g=e007 b=1f00
wraps() { # WRAP EXPECTED
    draws "wrap $1" "scene 7 1\nstate tex replace\ntexture 3 1 FF0000 00FF00 0000FF
state wrap $1\n$(quad -2 0 1)\n" "$2"
    draws "wrapv $1" "scene 1 7\nstate tex replace\ntexture 1 3 FF0000 00FF00 0000FF
state wrapv $1\n$(quad 0 -2 1)\n" "$2"
}
wraps repeat $g$b$r$g$b$r$g
wraps clamp $r$r$r$g$b$b$b
wraps mirror $g$r$r$g$b$b$g
draws 'wrapv same' "scene 1 3\nstate tex replace\ntexture 1 3 FF0000 00FF00 0000FF
state wrapv mirror\nstate wrapv same\nstate wrap clamp\n$(quad 0 -2 1)\n" $r$r$r

# Filters: two texels over four pixels, so that the middle ones are 1/4 and 3/4 of the way: 7.75 and
# 23.25 of 31. Environments and mipmaps by numbers too.
draws 'linear' "scene 4 1\nstate tex replace\nstate filter linear\nstate wrap clamp
texture 2 1 000000 FFFFFF\ntri 0 0 0 1 $t 0 0  8 0 0 1 $t 4 0  0 8 0 1 $t 0 4\n" '00000842f7bdffff'
draws 'modulate' "scene 1 1\nstate tex modulate\ntexture 1 1 808080
tri 0 0 0 1 255 0 0 255 0 0  8 0 0 1 255 0 0 255 0 0  0 8 0 1 255 0 0 255 0 0\n" '0080'
draws 'decal' "scene 1 1\nstate tex decal\ntexture 1 1 00FF0080
tri 0 0 0 1 255 0 0 255 0 0  8 0 0 1 255 0 0 255 0 0  0 8 0 1 255 0 0 255 0 0\n" '007c'
checks='texture 2 2 000000 FFFFFF FFFFFF 000000'
draws 'mipmap off' "scene 2 1\nstate tex replace\n$checks\n$(quad 0 0 2)\n" '00000000'
draws 'mipmap on' "scene 2 1\nstate tex replace\nstate mipmap on\n$checks\n$(quad 0 0 2)\n" '10841084'
draws 'mipmap on, large' "scene 2 1\nstate tex replace\nstate mipmap on\n$checks\n$(quad 0 0 1)\n" \
    '0000ffff'

# Which functions a sampler names.
printf "scene 2 2\nstate filter linear\nstate wrap mirror\nstate wrapv clamp\nstate mipmap on
state tex decal\ntexture pal4 2 3 1 01020304 0 0 0 0 0 0\n$(quad 0 0 1)\n" >"$out/right.scene"
sim "$out/right.scene" --needs >"$out/stdout" || fail 'needs of a texture'
for name in etch_source_texture etch_stage_texture_decal etch_filter_linear etch_texels_mirror_power \
    etch_texels_clamp etch_texels_index4 etch_texels_alpha4 etch_mipmap_level; do
    if grep -q -w $name "$out/stdout"; then pass; else fail "no $name: $(cat "$out/stdout")"; fi
done

# What is wrong.
scene '2: texel 1: "00FF00FF" is not RRGGBB$' 'scene 8 8\ntexture 2 1 FF0000 00FF00FF\n'
scene '2: texel 0: "FF000" is not RRGGBBAA' 'scene 8 8\ntexture 1 1 FF000\n'
scene '2: count of colours' 'scene 8 8\ntexture pal8 1 1 0\n'
scene '2: count of colours' 'scene 8 8\ntexture pal8 1 1 257\n'
scene '2: count of colours' 'scene 8 8\ntexture pal4 1 1 17\n'
scene '2: colour 1: "0" is not RRGGBBAA' 'scene 8 8\ntexture pal8 1 1 2 FF0000FF 0\n'
scene '2: colour is missing' 'scene 8 8\ntexture pal4 1 1 2 FF0000FF\n'
scene '2: texel' 'scene 8 8\ntexture pal4 1 1 2 FF0000FF 00FF00FF 2\n'
scene '2: texel' 'scene 8 8\ntexture pal8 2 1 1 FF0000FF 0 -1\n'
scene '2: texel is missing' 'scene 8 8\ntexture pal8 2 1 1 FF0000FF 0\n'
scene '2: unexpected "1"' 'scene 8 8\ntexture pal8 1 1 2 FF0000FF 00FF00FF 0 1\n'
scene '2: file is missing' 'scene 8 8\ntexture ppm t.ppm mask\n'
scene '2: cannot open none.ppm' 'scene 8 8\ntexture ppm t.ppm mask none.ppm\n'
printf 'P6 1 3 255\n\377\000\377\000\377\000\000\377\000' >"$out/m.ppm"
scene '2: m.ppm is 1 x 3, not 3 x 1 as the texture' 'scene 8 8\ntexture ppm t.ppm mask m.ppm\n'
scene '2: .*wrapv' 'scene 8 8\nstate wrapv up\n'
scene '2: .*mipmap' 'scene 8 8\nstate mipmap\n'
rm "$out/t.ppm" "$out/m.ppm"
