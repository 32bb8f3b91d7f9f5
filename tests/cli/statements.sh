# tests/cli: 2D shapes, state and triangles. Sourced by run.

scene '2: y is missing' 'scene 8 8\npoint 1\n'
scene '2: x: "32768" is not' 'scene 8 8\npoint 32768 0 1 2 3\n'
scene '2: y1: "-32769" is not' 'scene 8 8\nline 0 0 1 -32769 1 2 3\n'
scene '2: b is missing' 'scene 8 8\ndisc 1 1 1 2 3\n'
scene '2: unexpected "9"' 'scene 8 8\nfillrect 1 1 1 1 2 3 4 9\n'
draws 'shapes' 'scene 3 1\nfillrect 0 0 1 1 255 0 0\nline 1 0 1 9 0 255 0\ncircle 2 0 0 0 0 255\n' \
    '00f8e0071f00'

scene '2: state is missing' 'scene 8 8\nstate\n'
scene '2: unknown state "mist"' 'scene 8 8\nstate mist on\n'
scene '2: ztest: "smaller" is unknown' 'scene 8 8\nstate ztest smaller\n'
scene '2: zwrite: "2" is unknown' 'scene 8 8\nstate zwrite 2\n'
scene '2: height is missing' 'scene 8 8\nstate scissor 1 2 3\n'
scene '2: unexpected "1"' 'scene 8 8\nstate scissor off 1\n'
scene '2: atest: "256" is not' 'scene 8 8\nstate atest 256\n'
scene '2: stencil: "of" is unknown' 'scene 8 8\nstate stencil of\n'
scene '2: zpass is missing' 'scene 8 8\nstate stencil less 1 255 keep keep\n'
scene '2: mode: "best" is unknown' 'scene 8 8\nstate mode best\n'

v='0 0 0 1 255 0 0 255 0 0'
tri="tri $v  8 0 0 1 255 0 0 255 0 0  0 8 0 1 255 0 0 255 0 0"
ctri='ctri -1 -1 0 1 255 0 0 255 0 0  1 -1 0 1 255 0 0 255 0 0  -1 1 0 1 255 0 0 255 0 0'
scene '2: x is missing' "scene 8 8\ntri $v $v\n"
scene '2: unexpected "1"' "scene 8 8\n$tri 1\n"
scene '2: x: "32768" is not' 'scene 8 8\ntri 32768 0 0 1 0 0 0 0 0 0\n'
scene '3: y: "65536" is not' 'scene 8 8\nfrac 1\ntri 0 65536 0 1 0 0 0 0 0 0\n'
scene '3: x: "2147483648" is not' 'scene 8 8\nfrac 16\ntri 2147483648 0 0 1 0 0 0 0 0 0\n'
scene '2: z: "65536" is not' 'scene 8 8\ntri 0 0 65536 1 0 0 0 0 0 0\n'
scene '2: w must be' 'scene 8 8\ntri 0 0 0 0 0 0 0 0 0 0\n'
scene '2: w must be' 'scene 8 8\ntri 0 0 0 0.000001 0 0 0 0 0 0\n'
scene '2: a: "256" is not' 'scene 8 8\ntri 0 0 0 1 0 0 0 256 0 0\n'
scene '2: u: "a" is not a decimal' 'scene 8 8\ntri 0 0 0 1 0 0 0 0 a 0\n'
scene '2: x: 32768 does not fit 16.16' 'scene 8 8\nctri 32768 0 0 0 0 0 0 0 0 0\n'
scene '2: w: -32768\.00001 does not fit' 'scene 8 8\nctri 0 0 0 -32768.00001 0 0 0 0 0 0\n'

# State of fragments draws (fragments.sh) and does not concern shapes.
for state in 'blend alpha' 'tex modulate' 'atest 1' 'mode fast' 'stencil never 1 255 keep keep keep' \
    'fog linear 0 1 255 255 255' 'logic clear' 'colormask 0 0 0'; do
    draws "state $state is idle" "scene 1 1\nstate $state\npoint 0 0 255 0 0\n" '00f8'
done
draws 'blend off again' "scene 1 1\nstate blend add\nstate blend off\n$tri\n" '00f8'
draws 'texture state without texture' \
    "scene 1 1\nstate filter linear\nstate wrap mirror\nstate persp 0\n$tri\n" '00f8'

# Vertices are rounded once to 1/256 px: the pixel's centre is at 1/2.
a='0 1 255 255 255 255 0 0'
draws 'a vertex on the centre' "scene 1 1\nfrac 1\ntri 1 -9 $a 1 9 $a 9 0 $a\n" 'ffff'
draws 'a vertex 1/256 right of it' "scene 1 1\nfrac 8\ntri 129 -999 $a 129 999 $a 999 0 $a\n" '0000'
draws 'snapped half up to it' \
    "scene 1 1\nfrac 16\ntri 32639 -99999 $a 32639 99999 $a 99999 0 $a\n" 'ffff'
draws 'snapped half up past it' \
    "scene 1 1\nfrac 16\ntri 32896 -99999 $a 32896 99999 $a 99999 0 $a\n" '0000'

# Each depth test against a plane of 100, with a fragment at 99, 100 and 101, and what it wrote.
depth_test() {
    text='scene 3 1\ncleardepth 100\n'"state shade flat\nstate ztest $1\nstate zwrite $2\n"
    for x in 0 1 2; do
        z="$((99 + x)) 1 255 0 0 255 0 0"
        text="${text}state scissor $x 0 1 1\ntri 0 -9 $z  0 9 $z  9 0 $z\n"
    done
    draws "ztest $1 zwrite $2" "$text" "$3"
    sim "$out/right.scene" --depth "$out/o.z16" &&
        depths=$(od -An -v -tu1 "$out/o.z16" | tr -s ' ' | sed 's/^ //; s/ 0//g')
    if [ "$depths" = "$4" ]; then pass; else fail "ztest $1 zwrite $2: depths $depths"; fi
}
depth_test never 1 000000000000 '100 100 100'
depth_test less 1 00f800000000 '99 100 100'
depth_test equal 1 000000f80000 '100 100 100'
depth_test lequal 1 00f800f80000 '99 100 100'
depth_test greater 1 0000000000f8 '100 100 101'
depth_test notequal 1 00f8000000f8 '99 100 101'
depth_test gequal 1 000000f800f8 '100 100 101'
depth_test always 1 00f800f800f8 '99 100 101'
depth_test notequal 0 00f8000000f8 '100 100 100'
depth_test always 0 00f800f800f8 '100 100 100'
depth_test off 1 00f800f800f8 '100 100 100'

# Culling: counter-clockwise as seen is the front, until it is said otherwise.
cw="tri 0 0 $a 9 0 $a 0 9 $a"
ccw="tri 0 0 $a 0 9 $a 9 0 $a"
draws 'cull back drops clockwise' "scene 1 1\nstate cull back\n$cw\n" '0000'
draws 'cull back keeps counter-clockwise' "scene 1 1\nstate cull back\n$ccw\n" 'ffff'
draws 'cull front drops counter-clockwise' "scene 1 1\nstate cull front\n$ccw\n" '0000'
draws 'front cw turns it round' "scene 1 1\nstate cull back\nstate front cw\n$cw\n" 'ffff'
draws 'cull off' "scene 1 1\nstate cull back\nstate cull off\n$cw\n" 'ffff'

# The long edge runs through two centres and is a right edge: they are not covered.
draws 'ctri, y up' "scene 2 2\n$ctri\n" '0000000000f80000'
