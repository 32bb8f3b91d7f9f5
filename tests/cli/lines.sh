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
for state in 'blend add' 'atest 1' 'stencil always 1 255 keep keep keep'; do
    scene "3: lines and points are drawn with the depth test alone" \
        "scene 8 8\nstate $state\ncline 0 0 0 1 2 3  1 1 0 1 2 3\n"
done

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
