#!/bin/sh
# Golden scenes: tests/scenes/NAME.scene drawn by the simulator equals tests/golden/NAME.png.
#       golden.sh run|update|list BUILD [NAME]
# Each scene is drawn as it stands and in strips of 7 rows; both must equal the picture, pixel for
# pixel. A scene without a picture and a picture without a scene fail. Where they differ, the
# drawn and the difference picture go to BUILD/golden.
# See `make golden`, `make golden-update`, `make golden-list`.
mode=$1 build=$2 only=$3
golden=tests/golden out=$build/golden
passed=0 failed=0

# $1 name, $2 suffix of the output, the rest: options of the simulator
draw()
{
    name=$1 suffix=$2
    shift 2
    # shellcheck disable=SC2086
    $RUN "$build/etch-sim" "tests/scenes/$name.scene" -o "$out/$name$suffix.png" "$@"
}

# $1 name, $2 suffix, the rest: options
compare()
{
    draw "$@" || { echo "FAIL $1: the simulator failed" && return 1; }
    cmp -s "$golden/$1.png" "$out/$1$2.png" && rm "$out/$1$2.png" && return 0
    difference=$out/$1$2-difference.png
    # shellcheck disable=SC2086
    $RUN "$build/picture-diff" "$golden/$1.png" "$out/$1$2.png" "$difference" && return 0
    echo "FAIL $1: see $out/$1$2.png and $difference"
    return 1
}

run_scene()
{
    if [ ! -f "$golden/$1.png" ]; then
        echo "FAIL $1: no golden picture $golden/$1.png (look at it, then make golden-update SCENE=$1)"
        draw "$1" ""
        return 1
    fi
    compare "$1" "" && compare "$1" -strips --strip 7
}

scenes()
{
    [ -n "$only" ] && echo "$only" && return
    for scene in tests/scenes/*.scene; do
        [ -f "$scene" ] && basename "$scene" .scene
    done
}

count()
{
    if [ "$1" -eq 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
}

mkdir -p "$out" || exit 1
case $mode in
list)
    for name in $(scenes); do
        if [ -f "$golden/$name.png" ]; then state=golden; else state=missing; fi
        printf '%-8s %s\n' "$state" "$name"
    done
    ;;
update)
    for name in $(scenes); do
        draw "$name" "" || exit 1
        if cmp -s "$out/$name.png" "$golden/$name.png"; then
            rm "$out/$name.png"
        else
            mv "$out/$name.png" "$golden/$name.png" && echo "updated $golden/$name.png"
        fi
    done
    ;;
run)
    for name in $(scenes); do
        run_scene "$name"
        count $?
    done
    for picture in "$golden"/*.png; do
        name=$(basename "$picture" .png)
        [ -n "$only" ] || [ ! -f "$picture" ] || [ -f "tests/scenes/$name.scene" ] || {
            echo "FAIL $name: a golden picture without a scene"
            count 1
        }
    done
    [ $((passed + failed)) -gt 0 ] || { echo "FAIL no golden scene" && failed=1; }
    echo "golden: $passed scenes, whole and in strips of 7 rows"
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    ;;
*)
    echo "usage: golden.sh run|update|list BUILD [NAME]" >&2
    exit 2
    ;;
esac
