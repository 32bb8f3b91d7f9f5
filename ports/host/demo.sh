#!/bin/sh
# ports/host/demo.sh: draws the demo scenes into $BUILD/demo with $BUILD/etch-sim and prints what
# each frame took. Called by `make demo`. Needs only a shell. Fails if a frame drawn in strips
# differs from the whole one.
set -eu
sim=${BUILD:-build}/etch-sim
out=${BUILD:-build}/demo
scenes=$(dirname "$0")/../../tests/scenes
mkdir -p "$out"

# value NAME FILE: the value of a line of --stats.
value() { sed -n "s/^$1  *\([0-9]*\).*/\1/p" "$2"; }

# frame NAME SCENE [OPTIONS]: draws one scene and prints a row.
frame() {
    to=$out/$1
    scene=$2
    shift 2
    "$sim" "$scene" -o "$to.png" --raw "$to.565" --stats "$@" >"$to.stats"
    printf '%-36s %9s %9s %9s %9s\n' "$to.png" "$(value triangles "$to.stats")" \
        "$(value runs "$to.stats")" "$(value pixels "$to.stats")" "$(value ram "$to.stats")"
}

# same A B: the two frames are equal, bit for bit.
same() {
    if cmp -s "$out/$1.565" "$out/$2.565"; then
        echo "  the same, bit for bit, as $1"
    else
        echo "  DIFFERS from $1" >&2
        exit 1
    fi
}

printf '%-36s %9s %9s %9s %9s\n' frame triangles spans pixels 'RAM bytes'
frame shapes "$scenes/shapes.scene"
frame shapes-strips "$scenes/shapes.scene" --strip 16
same shapes shapes-strips
frame textures "$scenes/textures.scene"
frame textures-strips "$scenes/textures.scene" --strip 16
same textures textures-strips
frame teapots "$scenes/teapots.scene"
frame teapots-strips "$scenes/teapots.scene" --strip 16
same teapots teapots-strips

# Effects: shadows and reflections by stencil, trees by the alpha test, and all of it together.
for name in shadow penumbra mirror billboards museum; do
    frame "$name" "$scenes/$name.scene"
    frame "$name-strips" "$scenes/$name.scene" --strip 16
    same "$name" "$name-strips"
done

# The turntable: the teapot's scene with other angles, in strips of 16 rows and at once.
for angle in 0 45 90 135 180 225 270 315; do
    name=teapot-$(printf %03d $angle)
    sed -e "s|^model rotate y .*|model rotate y $angle|" \
        -e "s|^mesh |mesh $(cd "$scenes" && pwd)/|" "$scenes/teapot.scene" >"$out/$name.scene"
    frame "$name" "$out/$name.scene"
    frame "$name-strips" "$out/$name.scene" --strip 16
    same "$name" "$name-strips"
done
