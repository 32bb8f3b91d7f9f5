# tests/cli/needs.sh: what --needs says that a scene could do without. Sourced by run.
needs() { # WHAT LINE SCENE
    printf "$3" >"$out/needs.scene"
    sim "$out/needs.scene" --needs >"$out/stdout" || fail "needs of $1"
    if grep -q -x "$2" "$out/stdout"; then pass; else fail "$1: no \"$2\" in: $(cat "$out/stdout")"; fi
}
one='1 9 9 9 255 0 0'
w1='1 9 9 9 255'
two="tri 0 0 100 $one 8 0 100 $one 0 8 100 $one\n"
other="tri 8 8 900 $one 8 0 900 $one 0 8 900 $one\n"
same="tri 0 0 200 $one 8 0 200 $one 0 8 200 $one\n"
near='scene 8 8\nfrac 8\n'
needs 'triangles side by side' 'overlap    0 of .* pixels with depth are drawn again: no depth is needed' \
    "scene 8 8\nstate ztest less\n$two$other"
needs 'triangles over each other' 'overlap    28 of 28 pixels with depth are drawn again' \
    "scene 8 8\nstate ztest less\n$two$same"
needs 'the depths seen' 'range      depths 100 to 900 of 65535 are seen' "scene 8 8\nstate ztest less\n$two$other"
needs 'whole pixels' 'at centres 1 of 1: whole pixels, etch_triangle_fill, draw the same' \
    "${near}tri 128 128 0 $one 1152 128 0 $one 128 1152 0 $one\n"
needs 'parts of pixels' 'at centres 0 of 1' "${near}tri 128 128 0 $one 1152 129 0 $one 128 1152 0 $one\n"
needs 'one colour' 'one colour 1 of 1: flat kernels draw the same' "scene 8 8\n$two"
needs 'colours' 'one colour 0 of 1' "scene 8 8\ntri 0 0 0 $one 8 0 0 1 9 8 9 255 0 0 0 8 0 $one\n"
texture='state tex replace\nstate persp 1\ntexture 1 1 FFFFFF\n'
needs 'equal w' 'equal w    1 of 1: no perspective is needed' \
    "scene 8 8\n${texture}tri 0 0 0 $w1 0 0 8 0 0 $w1 1 0 0 8 0 $w1 0 1\n"
needs 'other w' 'equal w    0 of 1' \
    "scene 8 8\n${texture}tri 0 0 0 $w1 0 0 8 0 0 2 9 9 9 255 1 0 0 8 0 $w1 0 1\n"
needs 'a kernel that etch does not ship' 'flash .*made here and not weighed: gouraud_greater_1' \
    "scene 8 8\nstate ztest greater\n$two"

# More is linked, more weighs.
flash() { sim "$1" --needs | awk '/^flash/ { print $2 }'; }
printf 'scene 8 8\nline 0 0 5 5 9 9 9\n' >"$out/little.scene"
printf 'scene 8 8\nline 0 0 5 5 9 9 9\ndisc 4 4 3 9 9 9\n' >"$out/more.scene"
[ "$(flash "$out/little.scene")" -gt 1000 ] && [ "$(flash "$out/more.scene")" -gt "$(flash "$out/little.scene")" ] &&
    pass || fail "flash of a line: $(flash "$out/little.scene"), and a disc: $(flash "$out/more.scene")"

# Modes against the exact one.
needs 'colours dithered' 'mode       precise dithered: [1-9][0-9]* pixels are not as exact ones.* 1 at most; 26.6 .*' \
    "scene 8 8\ntri 0 0 0 1 10 20 30 255 0 0  8 0 0 1 90 80 70 255 0 0  0 8 0 1 0 90 10 255 0 0\n"
needs 'an affine texture' 'mode       affine: [1-9][0-9]* pixels are not as exact ones.*' \
    "scene 32 32\nstate tex replace\nstate persp 1\ntexture 4 1 FF0000 00FF00 0000FF FFFFFF
tri 0 0 0 1 9 9 9 255 0 0  32 0 0 8 9 9 9 255 4 0  0 32 0 1 9 9 9 255 0 0\n"
needs 'a divide a pixel' 'mode       divide every pixel: 0 pixels are not as exact ones.*' "$(cat "$out/needs.scene")\n"
sim "$out/little.scene" --needs | grep -q '^mode' && fail 'modes of a line' || pass
