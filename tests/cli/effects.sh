# tests/cli/effects.sh: shadows, reflections, and what meshes under effects must keep. Read by run.
here_scenes=$(cd "$here/../scenes" && pwd)
scene '2: entry is missing|2: .*entry' 'scene 8 8\nmodel matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0\n'
scene '2: .*d' 'scene 8 8\nmodel shadow 1 2 3 0 1 0\n'
scene '2: the lamp throws no shadow' 'scene 8 8\nmodel shadow 1 0 1  0 1 0 0\n'
scene '2: the lamp throws no shadow' 'scene 8 8\nmodel shadow point 1 2 3  0 1 0 -2\n'
scene '2: the lamp throws no shadow' 'scene 8 8\nmodel shadow 32767 0.0001 0  0 1 0 0\n'
scene '3: the model.s matrix leaves 16.16' \
    'scene 8 8\nmodel matrix 32767 32767 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nmodel scale 2\n'

# effect NAME TEXT [OPTIONS]: a scene with the meshes and textures of the golden scenes, to NAME.565.
effect()
{
    name=$1
    printf '%s\n' "$2" | sed -e "s|^mesh |mesh $here_scenes/|" \
        -e "s|ppm \([a-z]\)|ppm $here_scenes/\1|" -e "s|mask \([a-z]\)|mask $here_scenes/\1|" \
        >"$out/$name.scene"
    shift 2
    sim "$out/$name.scene" --raw "$out/$name.565" --stencil "$out/$name.s8" "$@" ||
        fail "$name.scene"
}

# Two ways to the same shadow: lamp at (2, 4, 0), floor y = 0; lamp far away in (1, 2, 0).
view='scene 80 60
camera 0 3 8  0 0 0
clear 200 180 160'
effect shadow-point "$view
light off
model shadow point 2 4 0  0 1 0 0
mesh cube.obj"
effect shadow-matrix "$view
light off
model matrix 1 -0.5 0 0  0 0 0 0  0 0 1 0  0 -0.25 0 1
mesh cube.obj"
same 'model shadow of a point' "$out/shadow-point.565" "$out/shadow-matrix.565"
effect shadow-far "$view
light off
model shadow 1 2 0  0 3 0 0
mesh cube.obj"
effect shadow-matrix "$view
light off
model matrix 1 -0.5 0 0  0 0 0 0  0 0 1 0  0 0 0 1
mesh cube.obj"
same 'model shadow of a light far away' "$out/shadow-far.565" "$out/shadow-matrix.565"

# Normals go with textures and with passes: a white texture and one moment change nothing.
lit="$view
state ztest less
state shade phong
light point 3 5 4 230 220 200
material 220 90 60
material specular 200 200 200 40
model rotate y 30"
effect phong "$lit
mesh cube.obj"
effect phong-white "$lit
state tex modulate
texture 1 1 FFFFFFFF
mesh cube.obj"
same 'Phong shading under a white texture' "$out/phong.565" "$out/phong-white.565"
effect phong-pass "$lit
motionblur 2
mesh cube.obj"
same 'Phong shading of two moments' "$out/phong.565" "$out/phong-pass.565"

# words FILE: a dump's numbers, one a line.
words() { od -An -v -w2 -tu2 "$1"; }
bytes() { od -An -v -w1 -tu1 "$1"; }
# count WHAT CONDITION: each pixel fulfils it, of $1 before, $2 after and $3 stencil; a hundred changed.
count()
{
    verdict=$(paste "$out/before.n" "$out/after.n" "$out/mask.n" | awk "
        function part(v, low, most) { return int(v / low) % (most + 1) }
        function dark(v, low, most) { return int(part(v, low, most) * 115 / 255 + 0.5) * low }
        \$1 != \$2 { changed++ }
        !($2) { wrong++ }
        END { print wrong + 0, (changed >= 100 ? \"some\" : \"too few\") }")
    if [ "$verdict" = '0 some' ]; then pass; else fail "$1: wrong, changed: $verdict"; fi
}

# The shadow's pixels are darkened exactly once: where the stencil counted, to 115 / 255 rounded, and
# nowhere else. shadow.scene up to its shadow, without and with it.
effect before "$(sed '/^# the shadow/,$d' "$here_scenes/shadow.scene")"
effect after "$(sed '/^state stencil off/,$d' "$here_scenes/shadow.scene")"
words "$out/before.565" >"$out/before.n"
words "$out/after.565" >"$out/after.n"
bytes "$out/after.s8" >"$out/mask.n"
count 'a shadow darkens once' '$3 <= 1 && $2 == \
    ($3 == 0 ? $1 : dark($1, 2048, 31) + dark($1, 32, 63) + dark($1, 1, 31))'

# The reflection stays within the floor that the stencil marked: mirror.scene up to the floor's marble.
effect before "$(sed '/^# below it/,$d' "$here_scenes/mirror.scene")"
effect after "$(sed '/^# the floor over it/,$d' "$here_scenes/mirror.scene")"
words "$out/before.565" >"$out/before.n"
words "$out/after.565" >"$out/after.n"
bytes "$out/before.s8" >"$out/mask.n"
count 'a reflection stays within the floor' '$1 == $2 || $3 == 1'

# The effects in strips and in the other byte order are the same pixels, and so on a panel.
for name in shadow mirror billboards penumbra museum; do
    sim "$here_scenes/$name.scene" --raw "$out/whole.565" || fail "$name.scene"
    sim "$here_scenes/$name.scene" --strip 16 --raw "$out/strips.565" || fail "$name.scene"
    same "$name.scene in strips" "$out/whole.565" "$out/strips.565"
    effect swapped "$(sed 's/^scene 320 240/&\nformat rgb565_swapped/' "$here_scenes/$name.scene")"
    same "$name.scene in the other byte order" "$out/whole.565" "$out/swapped.565"
done
sim "$here_scenes/mirror.scene" --raw "$out/whole.565" || fail mirror.scene
sim "$here_scenes/mirror.scene" --port ili9341 --raw "$out/panel.565" || fail 'mirror on a panel'
same 'mirror.scene on ILI9341' "$out/whole.565" "$out/panel.565"
