# tests/cli: soft shapes. Sourced by run.

scene '2: shape: "star" is unknown' 'scene 8 8\nsoft 255 star 1 2 3\n'
scene '2: opacity: "256" is not' 'scene 8 8\nsoft 256 disc 1 1 1 1 2 3\n'
scene '2: radius is missing' 'scene 8 8\nsoft 255 disc 1 1\n'
scene '2: from: "65536" is not' 'scene 8 8\nsoft 255 arc 1 1 3 1 65536 1 1 2 3\n'
scene '2: sweep: "65537" is not' 'scene 8 8\nsoft 255 arc 1 1 3 1 0 65537 1 2 3\n'
scene '2: needs 3 points' 'scene 8 8\nsoft 255 polygon 1 1 2 2 1 2 3\n'
scene '2: b is missing' 'scene 8 8\nsoft 255 line 1 1 3 1 1 1 2\n'
draws 'soft roundrect' 'scene 3 2\nfrac 1\nsoft 255 roundrect 1 0 5 3 0 255 0 0\n' \
    '008000f80080004000800040'
draws 'soft line in swapped pixels' \
    'scene 3 2\nformat rgb565_swapped\nfrac 1\nsoft 255 line 1 1 5 1 2 255 0 0\n' \
    '008000f80080000000000000'
draws 'soft frame' 'scene 3 3\nsoft 255 frame 0 0 3 3 0 1 255 0 0\n' \
    '00f800f800f800f8000000f800f800f800f8'
draws 'soft pie of a quarter' 'scene 2 2\nsoft 255 arc 0 0 9 0 0 16384 255 0 0\n' '00f800f800f800f8'
