# tests/cli: cameras, lights and OBJ files. Sourced by run.

scene '2: x is missing' 'scene 8 8\ncamera\n'
scene '2: y is missing' 'scene 8 8\ncamera 0 0 0 1 1 1 0\n'
scene '2: far is missing' 'scene 8 8\nperspective 45 1\n'
scene '2: left is missing' 'scene 8 8\nfrustum\n'
scene '2: far is missing' 'scene 8 8\nfrustum -1 1 -1 1 1\n'
scene '2: unexpected "9"' 'scene 8 8\nfrustum -1 1 -1 1 1 8 9\n'
scene '2: a light needs a direction' 'scene 8 8\nlight 0 0 0 1 2 3\n'
scene '2: unexpected "1"' 'scene 8 8\nlight off 1\n'
scene '2: model: "move" is unknown' 'scene 8 8\nmodel move 1\n'
scene '2: axis: "w" is unknown' 'scene 8 8\nmodel rotate w 1\n'
scene '3: the model.s matrix leaves' 'scene 8 8\nmodel scale 30000\nmodel scale 2\n'
scene '2: file is missing' 'scene 8 8\nmesh\n'
lights=
for i in 1 2 3 4 5 6 7 8 9; do lights="${lights}light 0 0 1 1 1 1\n"; done
scene '10: more than 8 lights' "scene 8 8\n$lights"

square='v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n'
rejects_mesh() { # MESSAGE STATEMENTS: a mesh that is right in a view that is not
    printf "${square}f 1 2 3 4\n" >"$out/square.obj"
    scene "$1" "scene 8 8\n$2\nmesh square.obj\n"
}
rejects_mesh '3: there is no such perspective' 'perspective 180 1 10'
rejects_mesh '3: there is no such perspective' 'perspective 45 10 1'
rejects_mesh '3: there is no such perspective' 'parallel 0 1 10'
rejects_mesh '3: there is no such .*frustum' 'frustum 1 1 -1 1 1 10'
rejects_mesh '3: there is no such .*frustum' 'frustum -1 1 2 2 1 10'
rejects_mesh '3: there is no such .*frustum' 'frustum -1 1 -1 1 0 10'
rejects_mesh '3: there is no such .*frustum' 'frustum -1 1 -1 1 10 1'
rejects_mesh '3: the camera has no direction' 'camera 1 1 1  1 1 1'

obj '0: no face' ''
obj '0: no face' 'v 0 0 0\n'
obj '1: y is missing' 'v 1\n'
obj '1: z: "q" is not a number' 'v 1 2 q\n'
obj '1: x: "1e" is not a number' 'v 1e 0 0\n'
obj '1: x: "nan" is not a number' 'v nan 0 0\n'
obj '2: unknown statement "w"' '# c\nw 1\n'
obj '1: unexpected "4"' 'vn 1 2 3 4\n'
obj '1: corner is missing' 'f\n'
obj '5: corner is missing' "${square}f 1 2\n"
obj '5: v: there is no 5 of 4' "${square}f 1 2 5\n"
obj '5: v: there is no 0 of 4' "${square}f 0 1 2\n"
obj '5: v: there is no -5 of 4' "${square}f -1 -2 -5\n"
obj '5: v: there is no 4294967297' "${square}f 1 2 4294967297\n"
obj '5: vt: there is no 1 of 0' "${square}f 1/1 2/1 3/1\n"
obj '5: vn: there is no 1 of 0' "${square}f 1//1 2//1 3//1\n"
obj '5: "1/" ends early' "${square}f 1/ 2/ 3/\n"
obj '5: "1//" ends early' "${square}f 1// 2 3\n"
obj '5: "1/1/1/1" is not' "${square}f 1/1/1/1 2 3\n"
obj '5: v: "" is not an index' "${square}f /1 2 3\n"
obj '5: v: "1.5" is not an index' "${square}f 1.5 2 3\n"
obj '2: a NUL byte' 'v 0 0 0\n\000\n'
obj '0: a coordinate is too large' 'v 1e30 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\n'
rm -f "$out/wrong.obj"
printf 'scene 8 8\n\nmesh none.obj\n' >"$out/mesh.scene"
rejects 'no such mesh' "^$out/mesh.scene:3: cannot open none.obj: No such file" "$out/mesh.scene" \
    -o "$out/o.png"
scene '2: cannot open sub/none.obj: ' 'scene 8 8\nmesh sub/none.obj\n'
scene '2: cannot open ./: ' 'scene 8 8\nmesh ./\n' # a folder

# A polygon, written in all the ways of OBJ, fills the same pixels: the middle of a view that is
# 4 high. In full light from the camera its colour is the material's.
view='camera 0 0 5 0 0 0\nparallel 4 1 10\nambient 0 0 0\nlight 0 0 1 255 255 255\n'
picture='0000000000000000''0000e007e0070000''0000e007e0070000''0000000000000000'
mesh() { # WHAT OBJ
    printf "$2" >"$out/right.obj"
    draws "obj: $1" "scene 4 4\n${view}material 0 255 0\nmesh right.obj\n" "$picture"
}
mesh 'a polygon' "${square}f 1 2 3 4\n"
mesh 'triangles' "${square}f 1 2 3\nf 1 3 4"
mesh 'negative indices' "${square}f -4 -3 -2 -1\n"
mesh 'normals' "${square}vn 0 0 2e-9\nf 1//1 2//1 3//1 4//-1\n"
mesh 'texture coordinates' "${square}vt 0\nvt 1 0.5 0\nf 1/1 2/2 3/2 4/-2\n"
mesh 'both' "${square}vt 0 0\nvn 0 0 1e20\nf 1/1/1 2/1/1 3/1/1 4/1/1\n"
mesh 'groups, comments, CR LF' "g a b\r\no x\r\ns off\r\nusemtl m\r\n# f 9 9 9\r\n${square}f 1 2 3 4 # f\r\n"
mesh 'exponents' 'v -.1e1 -10E-1 0\nv +1.e0 -0.0001e+4 0\nv 100e-2 1 0.0\nv -1 1 0\nf 1 2 3 4\n'
mesh 'w and colours' 'v -1 -1 0 1\nv 1 -1 0 .5 .5 .5\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n'
mesh 'continued lines' "${square}f 1 2 \\\\\n 3 \\\\\r\n4\n"
mesh 'a zero normal falls nowhere' "${square}v 9 9 9\nf 1 2 3 4\nf 5 5 5\n"

# A frustum that is even is perspective; one off the centre shows its part of it, whatever came before.
front='camera 0 0 2 0 0 0\nambient 0 0 0\nlight 0 0 1 255 255 255\nmaterial 0 255 0\n'
printf "${square}f 1 2 3 4\n" >"$out/right.obj"
for seen in 'frustum -1 1 -1 1 1 10' 'parallel 4 1 10\nfrustum -1 1 -1 1 1 10' \
    'canonical\nfrustum -1 1 -1 1 1 10' 'frustum 0 1 0 1 1 10\nperspective 90 1 10' \
    'frustum 0 1 0 1 1 10\nparallel 4 1 10'; do
    draws "$seen" "scene 4 4\n$front$seen\nmesh right.obj\n" "$picture"
done
draws 'a frustum off the centre' "scene 4 4\n${front}frustum 0 1 0 1 1 10\nmesh right.obj\n" \
    '0000000000000000''0000000000000000''e007e00700000000''e007e00700000000'
for seen in 'perspective 90 1 10' 'frustum -1.5 1.5 -1 1 1 10'; do
    printf "scene 48 32\nstate ztest less\n$front$seen\nmodel rotate y 50\nmodel scale 2\nmesh right.obj\n" \
        >"$out/right.scene"
    sim "$out/right.scene" --raw "$out/frustum.${seen%% *}" --depth "$out/z.${seen%% *}"
done
same 'an even frustum' "$out/frustum.perspective" "$out/frustum.frustum"
same 'an even frustum, depth' "$out/z.perspective" "$out/z.frustum"

# Small and large models keep their size; the parallel view is scaled with them.
for size in '0.001 0.004' '300 1200' '8000 32000'; do
    s=${size% *}
    printf "v -$s -$s 0\nv $s -$s 0\nv $s $s 0\nv -$s $s 0\nf 1 2 3 4\n" >"$out/right.obj"
    draws "a mesh of size $s" "scene 4 4\ncamera 0 0 0 0 0 -1\nparallel ${size#* } -9 9
ambient 255 255 255\nmaterial 0 255 0\nmesh right.obj\n" "$picture"
done
obj '0: a texture coordinate is too large' 'v 0 0 0\nvt 0 40000\nf 1/1 1/1 1/1\n'
