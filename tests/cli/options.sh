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
rejects 'no stencil file' '^etch-sim: a value is missing after --stencil' "$a" --stencil
rejects 'the stencil file is another' '^etch-sim: one file in two places' "$a" --raw "$out/o.x" \
    --stencil "$out/o.x"
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

# No output destroys a file that is read, nor another output, under whatever spelling or link.
spare=$out/spare
mkdir "$spare"
printf 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n' >"$spare/m.obj"
printf 'P6 1 1 255\n\377\000\000' >"$spare/t.ppm"
printf 'scene 8 8\ncamera 0 0 5 0 0 0\nmesh m.obj\ntexture ppm t.ppm\n' >"$spare/b.scene"
ln "$spare/m.obj" "$spare/hard.565"
ln -s t.ppm "$spare/soft.565"
ln -s new.565 "$spare/dangling.565"
echo old >"$spare/x.png"
refuses() { # FILE OPTIONS..: refused, naming the file, and everything is as it was
    ls "$spare" >"$out/names"
    cat "$spare"/[a-z].* >"$out/before"
    file=$1
    shift
    rejects "one file twice: $*" "^etch-sim: one file in two places: $file" "$spare/b.scene" "$@"
    cat "$spare"/[a-z].* >"$out/after"
    same "one file twice: $*" "$out/before" "$out/after"
    ls "$spare" >"$out/after"
    same "new files: $*" "$out/names" "$out/after"
}
for name in ./b.scene ../spare/b.scene m.obj .//m.obj t.ppm hard.565 soft.565; do
    refuses "$spare/$name" -o "$out/o.png" --raw "$spare/$name"
    refuses "$spare/$name" --depth "$spare/$name"
done
refuses "$spare/./x.png" -o "$spare/x.png" --raw "$spare/./x.png"
refuses "$spare/./n.png" -o "$spare/n.png" --depth "$spare/./n.png"
refuses "$spare/dangling.565" --raw "$spare/new.565" --depth "$spare/dangling.565"
refuses "$spare/../spare/new.565" --raw "$spare/dangling.565" --depth "$spare/../spare/new.565"
sim "$spare/b.scene" --raw "$spare/dangling.565" && [ -f "$spare/new.565" ] &&
    [ -L "$spare/dangling.565" ] && pass || fail 'a link to a file that does not exist yet'

# Files of the user's beside an output stay, whatever they are called.
for i in '' .0 .1; do echo mine >"$spare/x.png$i.part"; done
cp -r "$spare" "$out/kept"
sim "$spare/b.scene" -o "$spare/x.png" || fail 'over x.png'
for i in '' .0 .1; do same "x.png$i.part" "$spare/x.png$i.part" "$out/kept/x.png$i.part"; done
[ ! -e "$spare/x.png.2.part" ] && pass || fail 'a part is left'
sim "$a" --raw "$spare/p.0.part" --depth "$spare/p" || fail 'an output called like a part'
same 'an output called like a part' "$spare/p.0.part" "$out/p.565"
same 'the output that it is called after' "$spare/p" "$out/p.z16"

long=$(printf '%255s' '' | tr ' ' l)
sim "$a" --raw "$spare/$long" || fail 'the longest name'
same 'the longest name' "$spare/$long" "$out/p.565"

# An older output stays when the scene is wrong, or when another output cannot be written.
echo old >"$spare/old.565"
echo old >"$out/old"
ln -s old.565 "$spare/link.565"
printf 'scene 8 8\nmesh none.obj\n' >"$spare/c.scene"
sim "$spare/c.scene" --raw "$spare/old.565" 2>/dev/null && fail 'a wrong scene'
same 'older than a wrong scene' "$spare/old.565" "$out/old"
for other in "$out/none/o" "$out"; do
    sim "$a" --raw "$spare/old.565" --depth "$other" 2>/dev/null && fail 'no such folder'
    same 'older than a failure' "$spare/old.565" "$out/old"
    sim "$a" --raw "$spare/link.565" --depth "$other" 2>/dev/null && fail 'no such folder'
    same 'older than a failure, by a link' "$spare/old.565" "$out/old"
done
[ -z "$(ls "$spare" | grep '565\..*part')" ] && pass || fail 'a part is left after a failure'
rm -r "$spare" "$out/kept"

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
