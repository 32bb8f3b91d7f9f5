# tests/cli: images and what draws them. Sourced by run.

# Six pixels in four colours and a mask, for what follows: red green / pink blue / red white.
printf 'P6 2 3 255\n\377\0\0\0\377\0\377\0\377\0\0\377\377\0\0\377\377\377' >"$out/six.ppm"
printf 'P6 2 3 255\n\0\377\0\0\0\0\0\377\0\0\377\0\0\0\0\0\0\0' >"$out/mask.ppm"
printf 'P6 1 1 255\n\0\377\0' >"$out/one.ppm"

scene '2: format: "rgb888" is unknown' 'scene 8 8\nimage rgb888 six.ppm\n'
scene '2: format is missing' 'scene 8 8\nimage\n'
scene '2: file is missing' 'scene 8 8\nimage rgb565\n'
scene '2: cannot open none.ppm' 'scene 8 8\nimage rgb565 none.ppm\n'
scene '2: unexpected "lke"' 'scene 8 8\nimage rgb565 six.ppm lke\n'
scene '2: rgb565 has not a key' 'scene 8 8\nimage rgb565 six.ppm key 1 2 3\n'
scene '2: index2_key needs a key' 'scene 8 8\nimage index2_key six.ppm\n'
scene '2: rgb565_alpha needs a mask' 'scene 8 8\nimage rgb565_alpha six.ppm\n'
scene '2: index8 has not a mask' 'scene 8 8\nimage index8 six.ppm mask mask.ppm\n'
scene '2: mask: not of the same size' 'scene 8 8\nimage rgb565_alpha six.ppm mask one.ppm\n'
scene '2: the picture has more than 4 colours' 'scene 8 8\nimage index2 six.ppm\n'
scene '2: the picture has more than 2 colours' 'scene 8 8\nimage index1_key six.ppm key 1 2 3\n'
scene '2: there is no image to draw' 'scene 8 8\nblit 1 2\n'
scene '3: y is missing' 'scene 8 8\nimage rgb565 six.ppm\nblit 1\n'
scene '3: turn: "8" is not' 'scene 8 8\nimage rgb565 six.ppm\nblit 1 2 turn 8\n'
scene '3: opacity: "256" is not' 'scene 8 8\nimage rgb565 six.ppm\nblit 1 2 opacity 256\n'
scene '3: only one of turn and part' 'scene 8 8\nimage rgb565 six.ppm\nblit 1 2 turn 1 part 0 0 1 1\n'
scene '3: a compressed image is drawn by a plain' 'scene 8 8\nimage rgb565 six.ppm rle\nblit 1 2 turn 1\n'
scene '3: a compressed image is drawn by a plain' \
    'scene 8 8\nimage rgb565 six.ppm rle\nstretch 1 2 3 4\n'
scene '3: unexpected "linear"' 'scene 8 8\nimage rgb565 six.ppm\nblit 1 2 linear\n'
scene '3: index4_key is not sampled linearly' \
    'scene 8 8\nimage index4_key six.ppm key 0 0 0\nstretch 1 2 3 4 linear\n'
scene '3: index4_key is drawn in full opacity only' \
    'scene 8 8\nimage index4_key six.ppm key 0 0 0\nblit 1 2 opacity 9\n'
scene '3: left: "-1" is not' 'scene 8 8\nimage rgb565 six.ppm\nnine 1 2 3 4 -1 0 0 0\n'
scene '3: scale is missing' 'scene 8 8\nimage rgb565 six.ppm\nspin 1 2 3 4 5 6\n'
scene '3: angle: "65536" is not' 'scene 8 8\nimage rgb565 six.ppm\nspin 1 2 3 4 65536 6 7\n'
scene '3: a cursor is an image of index1' 'scene 8 8\nimage rgb565 six.ppm\ncursor 1 2 3 4 5\n'
scene '2: b is missing' 'scene 8 8\nxorrect 1 2 3 4 5 6\n'
scene '2: x2 is missing' 'scene 8 8\ncopyrect 1 2 3 4\n'
scene '2: dx: "32768" is not' 'scene 8 8\nscroll 1 2 3 4 32768 0 0 0\n'
scene '2: r is missing' 'scene 8 8\nscroll 1 2 3 4 5\n'

six='00f8e0071ff81f0000f8ffff'
for f in rgb565 index8 index4; do
    draws "$f" "scene 2 3\nimage $f six.ppm\nblit 0 0\n" $six
    draws "$f, compressed" "scene 2 3\nimage $f six.ppm rle\nblit 0 0\n" $six
    draws "$f, scaled to itself" "scene 2 3\nimage $f six.ppm\nstretch 0 0 2 3 linear\n" $six
    draws "$f, swapped" "scene 2 3\nformat rgb565_swapped\nimage $f six.ppm\nblit 0 0\n" $six
    draws "$f, swapped and half" \
        "scene 2 3\nformat rgb565_swapped\nclear 255 255 255\nimage $f six.ppm\nblit 0 0 opacity 128\n" \
        'effbef7ffffbff7beffbffff'
done
draws 'a key' 'scene 2 3\nimage rgb565_key six.ppm key 255 0 255\nblit 0 0\n' \
    '00f8e00700001f0000f8ffff'
draws 'a quarter' 'scene 3 2\nimage rgb565 six.ppm\nblit 0 0 turn 1\n' '00f81ff800f8ffff1f00e007'
draws 'alpha' 'scene 2 3\nimage rgb565_alpha six.ppm mask mask.ppm\nblit 0 0\n' \
    '00f800001ff81f0000000000'
draws 'a mask' 'scene 2 3\nimage mask4 mask.ppm color 0 0 255\nblit 0 0\n' '1f0000001f001f0000000000'
draws 'exclusive or' 'scene 2 1\nclear 0 0 255\nxorrect 1 0 9 9 255 0 255\n' '1f0000f8'
draws 'a copy' 'scene 3 1\nclear 0 0 255\npoint 0 0 255 0 0\ncopyrect 0 0 2 1 1\n' '00f800f81f00'
draws 'a scroll' 'scene 3 1\nclear 0 0 255\npoint 0 0 255 0 0\nscroll 0 0 3 9 1 0 255 0\n' \
    'e00700f81f00'
