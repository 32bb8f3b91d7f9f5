# tests/cli: files and statements about the frame. Sourced by run.

scene '0: no statement' ''
scene '0: no statement' '\n\n# only a comment\n'
scene '1: the first statement' 'clear 1 2 3\n'
scene '1: width is missing' 'scene'
scene '1: height is missing' 'scene 8\n'
scene '1: width: "0" is not' 'scene 0 8\n'
scene '1: height: "32768" is not' 'scene 8 32768\n'
scene '1: width: "99999999999999999999999" is not' 'scene 99999999999999999999999 8\n'
scene '1: width: "-8" is not' 'scene -8 8\n'
scene '1: width: "8x" is not' 'scene 8x 8\n'
scene '1: width: "8\.0" is not' 'scene 8.0 8\n'
scene '1: unexpected "8"' 'scene 8 8 8\n'
scene '2: a second "scene"' 'scene 8 8\nscene 8 8\n'
scene '2: unknown statement "dot"' 'scene 8 8\ndot 1 2\n'
scene '2: unknown statement "Clear"' 'scene 8 8\r\nClear 1 2 3\r\n'
scene '3: a NUL byte' 'scene 8 8\n\n\000\n'
scene '2: unknown statement "\?\?"' 'scene 8 8\n\377\001\n'
scene '4: rows: "0" is not' 'scene 8 8\n\n# strip\nstrip 0\n'
scene '2: format: "rgb888" is unknown' 'scene 8 8\nformat rgb888\n'
scene '2: frac: "17" is not' 'scene 8 8\nfrac 17\n'
scene '2: g is missing' 'scene 8 8\nclear 1\n'
scene '2: b: "256" is not' 'scene 8 8\nclear 1 2 256\n'
scene '2: a: "-1" is not' 'scene 8 8\nclear 1 2 3 -1\n'
scene '2: depth: "65536" is not' 'scene 8 8\ncleardepth 65536\n'
scene '2: stencil: "256" is not' 'scene 8 8\nclearstencil 256\n'

rejects 'no such scene' "^$out/none.scene:0: cannot open: " "$out/none.scene" -o "$out/o.png"
rejects 'a folder as a scene' "^$out:0: cannot (open|read): " "$out" -o "$out/o.png"

# A line of a million blanks, and a word of a million letters.
{ printf 'scene 8 8'; head -c 1000000 /dev/zero | tr '\0' ' '; printf '9\n'; } >"$out/long.scene"
rejects 'a long line' "^$out/long.scene:1: unexpected \"9\"" "$out/long.scene" -o "$out/o.png"
{ printf 'scene 8 8\n'; head -c 1000000 /dev/zero | tr '\0' 'x'; } >"$out/long.scene"
rejects 'a long word' "^$out/long.scene:2: unknown statement \"x{40}\.\.\"" "$out/long.scene" \
    -o "$out/o.png"
rm "$out/long.scene"

draws 'black' 'scene 2 1' '00000000'
draws 'CR LF, no final newline' 'scene 2 1\r\nclear 255 0 0 255\r\npoint 1 0 0 255 0' '00f8e007'
draws 'comments and tabs' '# a\n\tscene\t2 1 # b\nclear 0 0 255#c\n' '1f001f00'
draws 'a raw dump is plain' 'scene 2 1\nformat rgb565_swapped\nclear 255 0 0\n' '00f800f8'
draws 'the last format counts' 'scene 1 1\nclear 0 255 0\nformat rgb565_swapped\n' 'e007'
