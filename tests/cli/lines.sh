# tests/cli: lines and points with state, clipping as geometry. Sourced by run.

scene '2: y is missing' 'scene 8 8\ncline 1\n'
scene '2: z: "65536" is not' 'scene 8 8\ncline 0 0 65536 1 2 3  1 1 0 1 2 3\n'
scene '2: x is missing' 'scene 8 8\ncline 0 0 0 1 2 3\n'
scene '2: b: "256" is not' 'scene 8 8\ncline 0 0 0 1 2 256  1 1 0 1 2 3\n'
scene '3: x: "65536" is not' 'scene 8 8\nfrac 1\ncline 65536 0 0 1 2 3  1 1 0 1 2 3\n'
scene '2: size must be 0 to below 256' 'scene 8 8\nwideline 256 0 0 0 1 2 3  1 1 0 1 2 3\n'
scene '2: size must be 0 to below 256' 'scene 8 8\nwideline -1 0 0 0 1 2 3  1 1 0 1 2 3\n'
scene '2: cpoint must be square or round' 'scene 8 8\ncpoint 3 0 0 0 1 2 3\n'
scene '2: unexpected "1"' 'scene 8 8\ncpoint round 3 0 0 0 1 2 3 1\n'
scene '2: y1 is missing' 'scene 8 8\nddaline 1 1 1\n'
scene '2: y2: "32768" is not' 'scene 8 8\nhalfspace 1 1 1 1 1 32768 1 2 3\n'
scene '2: width: "0" is not' 'scene 8 8\ngradient 0 0 0 1 1 2 3 1 2 3 1 2 3\n'
scene '2: the gradient leaves' 'scene 8 8\ngradient 0 0 4 4 0 0 0 200 0 0 100 0 0\n'
scene '2: the gradient leaves' 'scene 8 8\ngradient 0 0 4 4 0 200 0 0 100 0 0 90 0\n'
scene '2: cohen or liang is missing' 'scene 8 8\nclipline 0 0 7 7 1 1 2 2 1 2 3\n'
scene '2: the bounds are empty' 'scene 8 8\nclipline liang 4 0 3 7 1 1 2 2 1 2 3\n'
scene '2: x is missing' 'scene 8 8\nclippolygon 0 0 7 7 1 2 3  1 1 2 2\n'
scene '2: y is missing' 'scene 8 8\nclippolygon 0 0 7 7 1 2 3  1 1 2 2 3 3 4\n'
many=$(printf '1 2 %.0s' $(seq 65))
scene '2: more than 64 vertices' "scene 8 8\nclippolygon 0 0 7 7 1 2 3  $many\n"
scene '2: guard or volume is missing' 'scene 8 8\ncvline 0 0 0 1 1 2 3  1 1 0 1 1 2 3\n'
scene '2: w: 32768 does not fit' 'scene 8 8\ncvtri guard 0 0 0 32768 1 2 3\n'
draws 'cline' 'scene 3 1\ncline 0 0 0 255 0 0  2 0 0 0 0 255\n' '00f810801f00'
draws 'cline is flat' 'scene 3 1\nstate shade flat\ncline 0 0 0 255 0 0  2 0 0 0 0 255\n' '00f800f800f8'
draws 'cline by depth' \
    'scene 3 1\nstate ztest less\ncline 0 0 5 255 0 0  2 0 5 255 0 0\ncline 0 0 4 0 0 255  2 0 6 0 0 255\n' \
    '1f0000f800f8'
draws 'cline swapped' 'scene 2 1\nformat rgb565_swapped\ncline 0 0 0 255 0 0  1 0 0 0 0 255\n' '00f81f00'
draws 'wideline' 'scene 1 3\nwideline 1.5 -2 1 0 255 0 0  3 1 0 255 0 0\n' '00f800f80000'
draws 'cpoint' 'scene 3 1\ncpoint square 2 1 0 0 255 0 0\n' '00f800f80000'
draws 'ddaline' 'scene 3 1\nddaline 1 0 9 0 255 0 0\n' '000000f800f8'
draws 'halfspace' 'scene 2 1\nhalfspace 1 -9 1 9 9 0 255 0 0\n' '000000f8'
draws 'gradient' 'scene 3 1\ngradient 0 0 3 1 0 0 0 0 0 255 0 0 0\n' '000010001f00'
draws 'clipline' 'scene 4 1\nclipline cohen 1 0 2 0 -9 0 9 0 255 0 0\n' '000000f800f80000'
draws 'clippolygon' 'scene 4 1\nclippolygon 1 0 2 0 255 0 0 -9 -9 20 -9 20 20 -9 20\n' '000000f800f80000'
draws 'cvline' 'scene 2 1\ncvline volume -3 0 0 1 255 0 0  0 0 0 1 255 0 0\n' '00f800f8'
draws 'cvtri' 'scene 2 1\ncvtri volume 0 3 0 1 255 0 0  0 -3 0 1 255 0 0 9 0 0 1 255 0 0\n' '000000f8'

# With what the state has for fragments (which pixels become what: tests/cli/fragments.c).
scene '2: alpha: "256" is not' 'scene 8 8\ncline 0 0 0 1 2 3  1 1 0 1 2 3 alpha 256 1\n'
scene '2: alpha is missing' 'scene 8 8\ncline 0 0 0 1 2 3  1 1 0 1 2 3 alpha 1\n'
scene '2: unexpected "9"' 'scene 8 8\ncpoint round 3 0 0 0 1 2 3 alpha 9 9\n'
scene '2: alpha is missing' 'scene 8 8\ncvtri guard 0 0 0 1 1 2 3 0 0 0 1 1 2 3 0 0 0 1 1 2 3 alpha 1 2\n'
on_red='clear 255 0 0\nstate blend alpha\n'
draws 'cline blended' "scene 3 1\n${on_red}cline 0 0 0 0 0 255  2 0 0 0 0 255 alpha 0 255\n" \
    '00f810801f00'
draws 'cline flat and blended' \
    "scene 2 1\nstate shade flat\n${on_red}cline 0 0 0 0 0 255  1 0 0 0 0 255 alpha 128 0\n" '10781078'
draws 'wideline blended' "scene 1 3\n${on_red}wideline 2 -2 1 0 0 0 255  3 1 0 0 0 255 alpha 128 128\n" \
    '1078107800f8'
draws 'cpoint blended' "scene 3 1\n${on_red}cpoint square 2 1 0 0 0 0 255 alpha 128\n" '1078107800f8'
draws 'cvline blended' \
    "scene 2 1\n${on_red}cvline volume -3 0 0 1 0 0 255  0 0 0 1 0 0 255 alpha 128 128\n" '10781078'
draws 'cvline is flat' \
    'scene 2 1\nstate shade flat\ncvline volume -1 0 0 1 255 0 0  0.5 0 0 1 0 0 255\n' '00f800f8'
draws 'cvtri blended' "scene 2 1\n${on_red}cvtri volume 0 3 0 1 0 0 255  0 -3 0 1 0 0 255 $(
    )9 0 0 1 0 0 255 alpha 128 128 128\n" '00f81078'
draws 'cvtri is flat' "scene 2 1\nstate shade flat\ncvtri volume 0 3 0 1 255 0 0  0 -3 0 1 0 0 255 $(
    )9 0 0 1 0 0 255\n" '000000f8'
list='canonical\nstate logic xor\nlist lines\nvertex -0.9 0 0 0 0 255\nvertex 0.9 0 0 0 0 255\nendlist\n'
draws 'lines of a list by logic' "scene 2 1\nclear 255 0 0\n$list" '1ff81ff8'
draws 'points of a list by stencil' \
    "scene 2 1\nclearstencil 1\nstate scissor 0 0 1 1\nclearstencil 2\nstate scissor off\n$(
    )canonical\nstate stencil equal 2 255 keep keep keep\nlist points 9\nvertex 0 0 0 255 0 0\nendlist\n" \
    '00f80000'
draws 'textures do not concern lines' \
    'scene 2 1\ntexture 1 1 00FF00\nstate tex replace\nstate blend add\ncline 0 0 0 255 0 0  1 0 0 255 0 0\n' \
    '00f800f8'

# Pixel work of the simulator's own.
scene '2: shader: "vertex" is unknown' 'scene 8 8\nshadertri vertex\n'
scene '2: y is missing' 'scene 8 8\nshadertri kernel 0 0 0 1 2 3 4\n'
scene '2: unexpected "7"' 'scene 8 8\nshadertri stage 0 0 0 1 2 3 8 0 0 1 2 3 0 8 0 1 2 3 7\n'
over='0 0 0 255 255 255  99 0 0 255 255 255  0 99 0 255 255 255\n'
draws 'shadertri kernel' "scene 6 1\nshadertri kernel $over" 'ffffffffffffffffef7bef7b'
draws 'shadertri kernel, swapped' "scene 1 5\nformat rgb565_swapped\nshadertri kernel $over" \
    'ffffffffffffffffef7b'
gray=$(echo "$over" | sed 's/255/128/g')
draws 'shadertri stage' "scene 2 1\nshadertri stage $gray" 'aa52aa52'
draws 'shadertri weights, 1/3 each' \
    'scene 1 1\nfrac 1\nshadertri weights 0 0 0 255 0 0  3 0 0 0 255 0  0 3 0 0 0 255\n' 'aa52'
