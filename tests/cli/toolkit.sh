# tests/cli: smooth and solid shapes. Sourced by run.

scene '2: shape: "star" is unknown' 'scene 8 8\nsmooth 255 star 1 2 3\n'
scene '2: opacity: "256" is not' 'scene 8 8\nsmooth 256 ellipse 1 1 1 1 1 2 3\n'
scene '2: needs 3 points' 'scene 8 8\nsolid polygon 1 1 2 2 1 2 3\n'
scene '2: needs 2 points' 'scene 8 8\nsolid stroke butt miter 1 1 1 1 2 3\n'
scene '2: cap: "flat" is unknown' 'scene 8 8\nsolid stroke flat miter 1 1 1 2 2 1 2 3\n'
scene '2: join: "mitre" is unknown' 'scene 8 8\nsolid stroke butt mitre 1 1 1 2 2 1 2 3\n'
scene '2: radius: below 0' 'scene 8 8\nsmooth 255 ellipse 1 1 -1 1 1 2 3\n'
scene '2: from: "65536" is not' 'scene 8 8\nsmooth 255 arc 1 1 1 1 65536 1 1 2 3\n'
scene '2: sweep: "65537" is not' 'scene 8 8\nsmooth 255 arc 1 1 1 1 0 65537 1 2 3\n'
scene '2: b is missing' 'scene 8 8\nsolid roundrect 1 1 2 2 0 1 2\n'
scene '2: the shape needs more than 8192 edges' \
    'scene 8 8\nsolid dashes round round 100 1 1 0 -8000 -8000 8000 8000 1 2 3\n'
draws 'smooth' 'scene 3 2\nfrac 1\nsmooth 255 roundrect 1 0 5 3 0 255 0 0\n' \
    '008000f80080004000800040'
draws 'smooth in swapped pixels, the same' \
    'scene 3 2\nformat rgb565_swapped\nfrac 1\nsmooth 255 roundrect 1 0 5 3 0 255 0 0\n' \
    '008000f80080004000800040'
draws 'opacity' 'scene 1 1\nsmooth 128 polygon 0 0 1 0 1 1 0 1 255 0 0\n' '0080'
draws 'solid arc of no sweep' 'scene 3 1\nsolid arc 1 0 2 0 0 0 255 0 0\n' '000000000000'
draws 'solid' 'scene 3 1\nsolid arc 1 0 2 0 0 65536 255 0 0\n' '00f800f800f8'
