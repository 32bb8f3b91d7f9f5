# tests/cli/vertex.sh: lights, materials, lists of vertices, select and feedback. Read by run.
scene '2: attenuation follows a "light point"' 'scene 8 8\nattenuation 1 0 0\n'
scene '3: attenuation follows a "light point"' 'scene 8 8\nlight 1 1 1 9 9 9\nattenuation 1 0 0\n'
scene '3: attenuation must not be negative' 'scene 8 8\nlight point 1 1 1 9 9 9\nattenuation 1 -1 0\n'
scene '3: quadratic is missing|3: .*quadratic' 'scene 8 8\nlight point 1 1 1 9 9 9\nattenuation 1 0\n'
scene '2: a light needs a direction' 'scene 8 8\nlight 0 0 0 9 9 9\n'
scene '2: specular light is phong or blinn' 'scene 8 8\nmaterial specular 1 2 3 4 gouraud\n'
scene '2: .*shininess' 'scene 8 8\nmaterial specular 1 2 3 256\n'
scene '2: .*g' 'scene 8 8\nmaterial emission 1\n'
scene '3: "state shade phong" is for meshes' \
    'scene 8 8\nstate shade phong\ntri 0 0 0 1 0 0 0 0 0 0 1 0 0 1 0 0 0 0 0 0 0 1 0 1 0 0 0 0 0 0\n'
scene '3: "state shade phong" is for meshes' 'scene 8 8\nstate shade phong\nlist triangles\n'
scene '2: .*kind' 'scene 8 8\nlist quads\n'
scene '2: size must be' 'scene 8 8\nlist points 0\n'
scene '2: size must be' 'scene 8 8\nlist points 256\n'
scene '2: this stands in a "list"' 'scene 8 8\nvertex 0 0 0 1 1 1\n'
scene '2: this stands in a "list"' 'scene 8 8\nindex 0\n'
scene '2: this stands in a "list"' 'scene 8 8\nendlist\n'
scene '3: "list" within "list"' 'scene 8 8\nlist lines\nlist lines\n'
scene '0: "list" without "endlist"' 'scene 8 8\nlist lines\n'
scene '3: .*index' 'scene 8 8\nlist lines\nindex -2\n'
scene '3: .*index' 'scene 8 8\nlist lines\nindex 256\n'
scene '4: "state tex" is on, but vertices of lists' \
    'scene 8 8\ntexture 1 1 FFFFFFFF\nstate tex replace\nlist triangles\n'
scene '2: .*x' 'scene 8 8\nselect 8 0\n'
scene '2: .*y' 'scene 8 8\nselect 0 -1\n'
scene '2: feedback follows a mesh' 'scene 8 8\nfeedback\n'
scene '3: feedback follows a mesh' 'scene 8 8\nfillrect 0 0 1 1 1 1 1\nfeedback\n'
scene '2: .*primitive' 'scene 8 8\nprimitive melt\n'
scene '2: .*percent' 'scene 8 8\nprimitive shrink\n'
scene '2: .*percent' 'scene 8 8\nprimitive shrink 0\n'
scene '2: .*percent' 'scene 8 8\nprimitive shrink 101\n'
scene '3: "primitive" is for triangles' 'scene 8 8\nprimitive wireframe\nlist lines\n'
cp tests/scenes/cube.obj "$out/cube.obj"
scene '4: "primitive" hands on colours' 'scene 8 8\nprimitive shrink 50\nstate shade phong\nmesh cube.obj\n'
scene '2: .*g' 'scene 8 8\nselect 0 0 1\n'
scene '2: .*r' 'scene 8 8\nselect 0 0 256 0 0\n'
point='scene 1 1\nlist points\nendlist\n'
scene '4: .*g' "${point}feedback 1\n"
scene '4: .*r' "${point}feedback 1 2 3\n"

# The lower left triangle of 4 x 4 pixels (6 of them, all at its edge); its edges, of which the lowest is
# below the frame; its primitive with dots at the corners; and itself too small for a pixel's centre.
lower='list triangles\nvertex -1 -1 0 0 0 255\nvertex 1 -1 0 0 0 255\nvertex -1 1 0 0 0 255\nendlist\n'
four='scene 4 4\ncanonical\n' none=0000000000000000
draws 'select draws an edge' "${four}${lower}select 1 2 255 0 0\n" \
    ${none}00f800000000000000f800f80000000000f800f800f80000
draws 'select draws no edge round nothing' "scene 4 4\ncanonical\nselect 1 2 255 0 0\n" \
    $none$none$none$none
draws 'feedback draws' "${four}${lower}feedback 0 255 0  255 0 0\n" \
    00f8000000000000e007e0070000000000f81f0000f800f800f81f0000f800f8
draws 'primitive wireframe' "${four}primitive wireframe\n$lower" \
    1f000000000000001f001f00000000001f0000001f0000001f00000000001f00
draws 'primitive wireframe by the state' "${four}state colormask 1 1 0\nprimitive wireframe\n$lower" \
    $none$none$none$none
draws 'primitive shrink' "${four}primitive shrink 10\n$lower" $none$none$none$none
draws 'primitive none' "${four}primitive shrink 10\nprimitive none\n$lower" \
    ${none}1f000000000000001f001f00000000001f001f001f000000

# A lower triangle by the canonical volume, one nearer in its left half, and what is under the pixels.
canonical='canonical
list triangles
vertex -1 -1 0 255 0 0
vertex 1 -1 0 255 0 0
vertex -1 1 0 255 0 0
endlist
ctri -1 -1 -0.5 1 0 255 0 255 0 0  0 -1 -0.5 1 0 255 0 255 0 0  -1 1 -0.5 1 0 255 0 255 0 0
select 0 3
select 2 3
select 3 0
feedback'
printf 'scene 4 4\n%s\n' "$canonical" >"$out/answers.scene"
answers=$(sim "$out/answers.scene")
if [ "$answers" = "select 0 3: 2 ctri
select 2 3: 1 list
select 3 0: 0 nothing
feedback triangle  0 1024 16384 0 255 0 255  512 1024 16384 0 255 0 255  0 0 16384 0 255 0 255" ]; then
    pass
else
    fail "select and feedback: $answers"
fi
