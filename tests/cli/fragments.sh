# tests/cli: the states of fragments: tests, blending, fog, raster operations, masks. Sourced by run.

scene '2: stencil: "of" is unknown' 'scene 8 8\nstate stencil of\n'
scene '2: reference: "256" is not' 'scene 8 8\nstate stencil less 256\n'
scene '2: sfail: "add" is unknown' 'scene 8 8\nstate stencil less 1 255 add keep keep\n'
scene '2: unexpected "1"' 'scene 8 8\nstate stencil off 1\n'
scene '2: mask: "256" is not' 'scene 8 8\nstate stencilmask 256\n'
scene '2: blend: "screen" is unknown' 'scene 8 8\nstate blend screen\n'
scene '2: alpha is missing' 'scene 8 8\nstate blend constant\n'
scene '2: alpha: "256" is not' 'scene 8 8\nstate blend constant 256\n'
scene '2: unexpected "1"' 'scene 8 8\nstate blend alpha 1\n'
scene '2: fog: "on" is unknown' 'scene 8 8\nstate fog on\n'
scene '2: start: "65536" is not' 'scene 8 8\nstate fog linear 65536\n'
scene '2: end: "7" is not' 'scene 8 8\nstate fog linear 7 7 1 2 3\n'
scene '2: density must not be negative' 'scene 8 8\nstate fog exp -1 1 2 3\n'
scene '2: density: "x" is not' 'scene 8 8\nstate fog exp x 1 2 3\n'
scene '2: b is missing' 'scene 8 8\nstate fog exp 1 1 2\n'
scene '2: logic: "not" is unknown' 'scene 8 8\nstate logic not\n'
scene '2: g is missing' 'scene 8 8\nstate colormask 1\n'
scene '2: b: "2" is not' 'scene 8 8\nstate colormask 1 1 2\n'

# A triangle over the whole frame, in a colour and depth of its own: over R G B A Z.
over() {
    printf 'tri 0 0 %s 1 %s 0 0  99 0 %s 1 %s 0 0  0 99 %s 1 %s 0 0\\n' \
        "$5" "$1 $2 $3 $4" "$5" "$1 $2 $3 $4" "$5" "$1 $2 $3 $4"
}
one='scene 1 1\nclear 255 0 0\n'
blue=$(over 0 0 255 255 0)
half=$(over 0 0 255 128 0)

# Blending, the first byte of a pixel being GGGBBBBB, the second RRRRRGGG.
draws 'blend alpha 255' "${one}state blend alpha\n$blue" 1f00
draws 'blend alpha 128' "${one}state blend alpha\n$half" 1078
draws 'blend alpha 0' "${one}state blend alpha\n$(over 0 0 255 0 0)" 00f8
draws 'blend add' "${one}state blend add\n$half" 1ff8
draws 'blend addalpha' "${one}state blend addalpha\n$half" 10f8
draws 'blend mul' "${one}state blend mul\n$(over 128 255 255 0 0)" 0080
draws 'blend constant' "${one}state blend constant 128\n$blue" 1078
draws 'blend off again' "${one}state blend alpha\nstate blend off\n$half" 1f00
draws 'flat blending' "${one}state shade flat\nstate blend alpha\n$half" 1078
draws 'blending clip-space triangles' "${one}state blend constant 128\nctri -1 -1 0 1 0 0 255 0 0 0  $(
    )9 -1 0 1 0 0 255 0 0 0  -1 9 0 1 0 0 255 0 0 0\n" 1078

# Alpha test, fog by depth, raster operations and masks.
draws 'atest at the reference' "${one}state atest 128\n$half" 1f00
draws 'atest above' "${one}state atest 129\n$half" 00f8
draws 'fog at its end' "${one}state fog linear 0 100 0 255 0\n$(over 0 0 255 255 100)" e007
draws 'fog half way' "${one}state fog linear 0 100 0 255 0\n$(over 0 0 255 255 50)" 1004
draws 'fog before its start' "${one}state fog linear 50 100 0 255 0\n$(over 0 0 255 255 50)" 1f00
draws 'fog exp, far' "${one}state fog exp 20 0 255 0\n$(over 0 0 255 255 65535)" e007
draws 'fog exp, 1/e' "${one}state fog exp 1 0 255 0\n$(over 0 0 255 255 65535)" 0b05
draws 'fog exp 0' "${one}state fog exp 0 0 255 0\n$(over 0 0 255 255 65535)" 1f00
draws 'logic xor' "${one}state logic xor\n$blue" 1ff8
draws 'logic xor twice' "${one}state logic xor\n$blue$blue" 00f8
draws 'logic invert' "${one}state logic invert\n$blue" ff07
draws 'logic takes the place of blending' "${one}state blend alpha\nstate logic copy\n$half" 1f00
draws 'colormask' "${one}state colormask 1 1 0\n$(over 0 255 255 255 0)" e007
draws 'colormask with a clear' "scene 1 1\nstate colormask 0 0 0\nclear 255 0 0\n$blue" 00f8

# Stencil: a mask of the left column, then where it is, where it is not, and what it becomes.
s='scene 2 1\nclear 255 0 0\nclearstencil 5\nstate stencil always 7 255 keep keep replace\n'
s="${s}state scissor 0 0 1 1\nstate colormask 0 0 0\n${blue}state scissor off\nstate colormask 1 1 1\n"
draws 'stencil equal' "${s}state stencil equal 7 255 keep keep keep\n$blue" 1f0000f8
draws 'stencil notequal' "${s}state stencil notequal 7 255 keep keep keep\n$blue" 00f81f00
draws 'stencil less: 6 < 7' "${s}state stencil less 6 255 keep keep keep\n$blue" 1f0000f8
draws 'stencil masked' "${s}state stencil equal 5 5 keep keep keep\n$blue" 1f001f00
stencil() { # NAME TEXT VALUES: what the stencil plane becomes, whole and in strips
    printf "$2" >"$out/right.scene"
    for options in '' '--strip 1' '--port memory'; do
        # shellcheck disable=SC2086
        sim "$out/right.scene" $options --stencil "$out/p.s8" &&
            values=$(od -An -v -tu1 "$out/p.s8" | tr -s ' ' | sed 's/^ //')
        if [ "$values" = "$3" ]; then pass; else fail "$1 $options: stencil $values"; fi
    done
}
stencil 'as cleared' 'scene 2 2\nclearstencil 9\nstate scissor 0 1 1 1\nclearstencil 8\n' '9 9 8 9'
stencil 'without a clear' 'scene 2 1\n' '0 0'
stencil 'replaced' "$s" '7 5'
stencil 'stencilmask' "scene 1 1\nclearstencil 5\nstate stencilmask 3\nstate stencil always 255 255 $(
    )keep keep replace\n$blue" 7
stencil 'zfail' "scene 1 1\ncleardepth 3\nstate ztest less\nstate stencil always 0 0 zero invert incr\n$(
    over 0 0 255 255 9)" 255
stencil 'sfail' "scene 1 1\nclearstencil 0\nstate stencil never 0 0 decrwrap keep keep\n$blue" 255
stencil 'dropped by alpha' "scene 1 1\nstate atest 200\nstate stencil always 9 9 replace replace replace\n$half" 0

# Perspective: 5/8 of white on the screen is 10/13 of it in space.
wide='tri -1 0 0 1 255 255 255 255 0 0  3 0 0 2 0 0 0 255 0 0  -1 99 0 1 255 255 255 255 0 0'
near='ctri -3 1 0 1 255 255 255 255 0 0  5 1 0 1 0 0 0 255 0 0  -3 -197 0 1 255 255 255 255 0 0'
draws 'colours in perspective' "scene 1 1\n$wide\n" 18c6
draws 'the same with persp 0' "scene 1 1\nstate persp 0\n$wide\n" f39c
draws 'the same without distances' "scene 1 1\n$near\n" f39c
draws 'the same of a ctri' "scene 1 1\n$(echo "$near" | sed 's/5 1 0 1/10 2 0 2/')\n" 18c6
draws 'the same of a ctri with persp 0' \
    "scene 1 1\nstate persp 0\n$(echo "$near" | sed 's/5 1 0 1/10 2 0 2/')\n" f39c
draws 'flat colours have no perspective' "scene 1 1\nstate shade flat\n$wide\n" ffff
