# tests/cli: polygons, curves, conics, implicit shapes and sorted blocks. Sourced by run.

scene '2: rule: "odd" is unknown' 'scene 8 8\nfillpolygon odd 0 0 8 0 8 8 1 2 3\n'
scene '2: rule is missing' 'scene 8 8\nfillpolygon\n'
scene '2: a contour needs three corners' 'scene 8 8\nfillpolygon evenodd 0 0 8 0 1 2 3\n'
scene '2: a contour needs three corners' 'scene 8 8\npolygon 1 2 3\n'
scene '2: a contour needs three corners' \
    'scene 8 8\nfillpolygon evenodd 0 0 8 0 8 8 hole 1 1 2 2 1 2 3\n'
scene '2: a contour needs three corners' \
    'scene 8 8\nfillpolygon evenodd hole 0 0 8 0 8 8 1 2 3\n'
scene '2: y is missing' 'scene 8 8\nfillpolygon evenodd 0 0 8 0 8 8 9 1 2 3\n'
scene '2: x: "32768" is not' 'scene 8 8\npolygon 0 0 32768 0 8 8 1 2 3\n'
scene '2: x: "a" is not' 'scene 8 8\npolygon 0 0 8 0 a 8 1 2 3\n'
scene '2: b: "256" is not' 'scene 8 8\npolygon 0 0 8 0 8 8 1 2 256\n'
draws 'fillpolygon' \
    'scene 3 2\nfillpolygon evenodd 0 0 3 0 3 2 0 2 hole 1 0 2 0 2 1 1 1 255 0 0\n' \
    '00f8000000f800f800f800f8'
draws 'nonzero fills what winds twice' \
    'scene 2 1\nfillpolygon nonzero 0 0 2 0 2 1 0 1 hole 0 0 1 0 1 1 0 1 255 0 0\n' '00f800f8'
draws 'evenodd does not' \
    'scene 2 1\nfillpolygon evenodd 0 0 2 0 2 1 0 1 hole 0 0 1 0 1 1 0 1 255 0 0\n' '000000f8'
scene '2: a contour needs three corners' 'scene 8 8\nfillpolygon inversion 0 0 8 0 1 2 3\n'
scene '2: this polygon has no triangles' \
    'scene 8 8\nfillpolygon triangles 0 0 8 8 8 0 0 8 1 2 3\n'
scene '2: this polygon has no triangles' \
    'scene 8 8\npolygon triangles 0 0 8 0 8 8 0 8 hole 9 9 12 9 12 12 1 2 3\n'
scene '2: rule: "inversion" is unknown' 'scene 8 8\nfillpath inversion move 0 0 1 2 3\n'
draws 'polygon triangles' 'scene 3 3\npolygon triangles 0 0 2 0 2 2 0 2 255 0 0\n' \
    '00f800f800f800f800f800f800f800f800f8'
# Three ways to fill are the same pixels, whole and in strips: teeth, far vertices, a hole.
shape='3 2 60 7 55 40 32000 31000 20 41 5 58 hole 12 12 30 20 25 30 14 28 9 17 255 200 0'
printf 'scene 64 64\nclear 9 9 9\nfillpolygon evenodd %s\n' "$shape" >"$out/right.scene"
sim "$out/right.scene" --raw "$out/evenodd.565"
for way in nonzero inversion triangles; do
    word=$shape
    [ $way = nonzero ] && word=$(echo "$shape" | sed 's/12 12 30 20 25 30 14 28 9 17/9 17 14 28 25 30 30 20 12 12/')
    printf 'scene 64 64\nclear 9 9 9\nfillpolygon %s %s\n' "$way" "$word" >"$out/right.scene"
    for options in '' '--strip 7'; do
        # shellcheck disable=SC2086
        sim "$out/right.scene" $options --raw "$out/o.565"
        same "fillpolygon $way $options" "$out/o.565" "$out/evenodd.565"
    done
done
draws 'polygon' 'scene 3 3\npolygon 0 0 2 0 2 2 0 2 255 0 0\n' \
    '00f800f800f800f8000000f800f800f800f8'

scene '2: a path begins with move' 'scene 8 8\nfillpath evenodd line 1 1 1 2 3\n'
scene '2: a path begins with move' 'scene 8 8\nfillpath evenodd 1 2 3\n'
scene '2: y is missing' 'scene 8 8\nfillpath evenodd move 1\n'
scene '2: x is missing' 'scene 8 8\nfillpath evenodd move 1 1 cubic 1 1 2 2\n'
scene '3: x: "65536" is not' 'scene 8 8\nfrac 1\nfillpath evenodd move 65536 0 1 2 3\n'
scene '2: r: "lin" is not' 'scene 8 8\nfillpath evenodd move 1 1 lin 1 2\n'
draws 'fillpath, whose edge is left of a centre' \
    'scene 2 1\nfrac 8\nfillpath nonzero move 128 0 line 384 0 line 384 256 line 128 256 255 0 0\n' \
    '00f80000'
draws 'a path of two contours' \
    'scene 3 1\nfillpath evenodd move 0 0 line 1 0 line 1 1 line 0 1 move 2 0 line 3 0 line 3 1 line 2 1 255 0 0\n' \
    '00f8000000f8'
draws 'curves of a path' \
    'scene 1 2\nfillpath evenodd move -4 2 quadratic 0 0 4 2 255 0 0\n' '000000f8'

scene '2: curve: "arc" is unknown' 'scene 8 8\nbezier arc 0 0 1 1 2 2 1 2 3\n'
scene '2: b is missing' 'scene 8 8\nbezier quadratic 0 0 1 1 2 2 1 2\n'
scene '2: g is missing' 'scene 8 8\nbezier cubic 0 0 1 1 2 2 1 2 3\n'
draws 'bezier' 'scene 3 1\nbezier quadratic 0 0 1 0 2 0 255 0 0\n' '00f800f800f8'
draws 'cubic bezier' 'scene 3 1\nbezier cubic 0 0 1 0 1 0 2 0 255 0 0\n' '00f800f800f8'

scene '2: a: "1073741825" is not' 'scene 8 8\nquadric 1073741825 0 0 0 0 0 1 2 3\n'
scene '2: f is missing' 'scene 8 8\nquadric 1 2 3 4 5\n'
draws 'quadric' 'scene 3 1\nquadric 1 0 1 -2 0 0 255 0 0\n' '000000f80000'
scene '2: implicit: "torus" is unknown' 'scene 8 8\nimplicit torus\n'
scene '2: radius: "1001" is not' 'scene 8 8\nimplicit superellipse 1 1 1001 1 2 3\n'
scene '2: period: "1" is not' 'scene 8 8\nimplicit waves 1 0 1 2 3\n'
scene '2: level: "201" is not' 'scene 8 8\nimplicit waves 8 201 1 2 3\n'
draws 'superellipse' 'scene 3 1\nimplicit superellipse 1 0 1 255 0 0\n' '000000f80000'
draws 'superellipses at the ends of int16' \
    'scene 1 1\nimplicit superellipse 32767 -32768 1000 255 0 0\nimplicit superellipse -32768 32767 1000 255 0 0\n' \
    '0000'
draws 'waves' 'scene 1 2\nimplicit waves 4 -50 255 0 0\nimplicit waves 2 200 0 0 255\n' '1f001f00'

scene '2: sorted: "bsp" is unknown' 'scene 8 8\nsorted bsp\n'
scene '2: buckets is missing' 'scene 8 8\nsorted table\n'
scene '2: buckets: "0" is not' 'scene 8 8\nsorted table 0\n'
scene '2: room: "65535" is not' 'scene 8 8\nsorted newell 65535\n'
scene '3: "sorted" within "sorted"' 'scene 8 8\nsorted newell\nsorted newell\n'
scene '2: "end" without "sorted"' 'scene 8 8\nend\n'
scene '0: "sorted" without "end"' 'scene 8 8\nsorted newell\n'
scene '4: "sorted" draws colours and depth only' \
    'scene 8 8\nsorted newell\nstate blend add\nend\n'

# Near triangles come first, and are drawn last, in vertex 0's colour if flat.
near='tri 0 -9 10 1 255 0 0 255 0 0  0 9 10 1 255 0 0 255 0 0  9 0 10 1 255 0 0 255 0 0'
far='tri 0 -9 20 1 0 0 255 255 0 0  0 9 20 1 0 255 0 255 0 0  9 0 20 1 0 255 0 255 0 0'
draws 'unsorted' "scene 1 1\nstate shade flat\n$near\n$far\n" '1f00'
draws 'sorted newell' "scene 1 1\nstate shade flat\nsorted newell\n$near\n$far\nend\n" '00f8'
draws 'sorted table' "scene 1 1\nstate shade flat\nsorted table 65535\n$near\n$far\nend\n" '00f8'
draws 'a table of one bucket' "scene 1 1\nstate shade flat\nsorted table 1\n$near\n$far\nend\n" '1f00'
draws 'no room for the second' \
    "scene 1 1\nstate shade flat\nsorted newell 1\n$far\n$near\nend\n" '1f00'
draws 'unsorted after the end' \
    "scene 1 1\nstate shade flat\nsorted newell\n$near\nend\n$far\n" '1f00'
