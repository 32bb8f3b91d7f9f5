# tests/cli: options, outputs and ports. Sourced by run.

printf 'scene 5 9\nclear 10 90 200\ndisc 2 4 3 255 0 0\nstate ztest less\n%s\n' \
    'tri 0 0 9 1 255 0 0 255 0 0  5 0 60000 1 0 255 0 255 0 0  0 9 30000 1 0 0 255 255 0 0' \
    >"$out/a.scene"
a=$out/a.scene

rejects 'no scene' '^etch-sim: no scene'
rejects 'two scenes' '^etch-sim: more than one scene' "$a" "$a"
rejects 'an unknown option' '^etch-sim: unknown option --fast' "$a" --fast
rejects 'no value' '^etch-sim: a value is missing after -o' "$a" -o
rejects 'twice' '^etch-sim: given twice: -o' "$a" -o "$out/o.png" -o "$out/o.ppm"
rejects 'another picture' '^etch-sim: a picture.s name ends in' "$a" -o "$out/o.gif"
rejects 'no picture name' '^etch-sim: a picture.s name ends in' "$a" -o png
rejects 'the same file' '^etch-sim: one file in two places' "$a" --raw "$out/o.x" --depth "$out/o.x"
rejects 'over the scene' '^etch-sim: one file in two places' "$a" --raw "$a"
rejects 'stencil' '^etch-sim: not supported yet: --stencil' "$a" --stencil "$out/o.s8"
rejects 'no rows' '^etch-sim: --strip takes rows' "$a" --strip 0 -o "$out/o.png"
rejects 'rows' '^etch-sim: --strip takes rows' "$a" --strip x -o "$out/o.png"
rejects 'a port' "^$a:0: no port \"tv\"; there are: memory strips" "$a" --port tv -o "$out/o.png"
rejects 'a missing folder' "^$out/none/o.png:0: cannot write: " "$a" -o "$out/none/o.png"
rejects 'one of two' "^$out/none/o.png:0: cannot write: " "$a" -o "$out/none/o.png" \
    --raw "$out/o.565"
rejects 'one of three' "^$out/none/o:0: cannot write: " "$a" -o "$out/o.png" --raw "$out/o.565" \
    --depth "$out/none/o"
rejects 'a folder as output' "^$out:0: cannot write: " "$a" -o "$out/o.png" --raw "$out"
if [ -e /dev/full ]; then
    rejects 'a full disk' '^/dev/full:0: cannot write: ' "$a" -o "$out/o.png" --raw /dev/full
    [ -c /dev/full ] && pass || fail '/dev/full was replaced'
fi

# Every port, strip height and format gives the same colours and depths.
sim "$a" --raw "$out/o.565" --depth "$out/o.z16" || fail 'whole frame'
for options in '--strip 1' '--strip 2' '--strip 7' '--strip 9' '--strip 32767' '--port strips' \
    '--port strips1' '--port memory --strip 3' '--port strips1 --strip 4'; do
    # shellcheck disable=SC2086
    sim "$a" $options --raw "$out/p.565" --depth "$out/p.z16" || fail "$options"
    same "$options: colours" "$out/o.565" "$out/p.565"
    same "$options: depths" "$out/o.z16" "$out/p.z16"
done
{ cat "$a" && echo 'format rgb565_swapped' && echo 'strip 2'; } >"$out/b.scene"
sim "$out/b.scene" --raw "$out/p.565" --depth "$out/p.z16" -o "$out/p.png" || fail 'swapped'
sim "$a" -o "$out/o.png" || fail 'a picture'
same 'swapped: colours' "$out/o.565" "$out/p.565"
same 'swapped: depths' "$out/o.z16" "$out/p.z16"
same 'swapped: picture' "$out/o.png" "$out/p.png"

# A picture in PPM: header, then the bytes of each pixel.
printf 'scene 2 1\nclear 255 0 0\npoint 1 0 0 0 255\n' >"$out/c.scene"
sim "$out/c.scene" -o "$out/p.ppm" || fail 'ppm'
printf 'P6\n2 1\n255\n\377\000\000\000\000\377' >"$out/q.ppm"
same 'ppm' "$out/p.ppm" "$out/q.ppm"

# An output replaces an older one; a link is written through.
echo old >"$out/q.565"
ln -s q.565 "$out/r.565"
sim "$a" --raw "$out/r.565" || fail 'through a link'
same 'through a link' "$out/o.565" "$out/q.565"
sim "$a" --raw "$out/q.565" || fail 'over a file'
same 'over a file' "$out/o.565" "$out/q.565"
sim "$a" --raw /dev/stdout >"$out/q.565" || fail 'to a pipe'
same 'to stdout' "$out/o.565" "$out/q.565"

# What is printed.
has() { # LINE, of the last output
    if grep -q -x "$1" "$out/stdout"; then pass; else
        fail "no line \"$1\" in: $(cat "$out/stdout")"
    fi
}
printf 'scene 20 10\nfillrect 2 3 5 4 255 0 0\nline 0 0 40 0 9 9 9\nrect 18 8 9 9 9 9 9\n' \
    >"$out/d.scene"
sim "$out/d.scene" --stats --strip 4 >"$out/stdout" || fail 'stats'
has 'triangles  0'
has 'runs       4' # of the fillrect: 20 pixels; the line has 20, the rectangle's corner 3
has 'pixels     43'
has 'flushed    400 bytes in 3 transfers'
has 'ram        320 bytes: colour 320, depth 0, vertices 0'
rm -f "$out"/o.*
sim "$a" --needs --strip 4 -o "$out/o.png" >"$out/stdout" || fail 'needs'
has 'kernels    etch_kernel_gouraud_less'
has 'planes     colour, depth'
[ -e "$out/o.png" ] && fail '--needs drew something' || pass
