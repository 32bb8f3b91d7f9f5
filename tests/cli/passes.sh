# tests/cli: passes over the frame. Sourced by run.

scene '2: antialias is missing' 'scene 8 8\nantialias\n'
scene '2: antialias: "csaa" is unknown' 'scene 8 8\nantialias csaa\n'
scene '2: n is missing' 'scene 8 8\nantialias ssaa\n'
scene '2: n: "5" is not' 'scene 8 8\nantialias ssaa 5\n'
scene '2: the frame is too large for ssaa 4' 'scene 8192 8\nantialias ssaa 4\n'
scene '2: the frame is too wide for shared' 'scene 32767 8\nantialias shared\n'
scene '2: accumulate takes 2, 4, 8 or 16' 'scene 8 8\nantialias accumulate 6\n'
scene '2: unexpected "4"' 'scene 8 8\nantialias msaa 4\n'
scene '2: n: "0" is not' 'scene 8 8\nmotionblur 0\n'
scene '2: n: "257" is not' 'scene 8 8\nmotionblur 257\n'
scene '2: y is missing' 'scene 8 8\nmotion 1\n'
scene '2: x: 32768 does not fit' 'scene 8 8\nmotion 32768 0\n'
scene '2: filter: "median" is unknown' 'scene 8 8\nfilter median\n'
scene '2: weight: "128" is not' 'scene 8 8\nfilter kernel 128\n'
scene '2: divisor is missing' 'scene 8 8\nfilter kernel 0 0 0 0 1 0 0 0 0\n'
scene '2: divisor: "0" is not' 'scene 8 8\nfilter kernel 0 0 0 0 1 0 0 0 0 0 0\n'
scene '2: bias: "256" is not' 'scene 8 8\nfilter kernel 0 0 0 0 1 0 0 0 0 1 256\n'
scene '2: width: "8" is not' 'scene 8 8\nexchange 1 0 8 8 0\n'
scene '2: x2: "5" is not' 'scene 8 8\nexchange 0 0 4 8 5\n'
scene '2: the two images overlap' 'scene 8 8\nexchange 0 0 4 8 3\n'

# A white triangle over the left 3/8 of a pixel column: how many of its samples are covered. Samples
# of 2 x 2 lie at 1/4 and 3/4; of msaa at 1/8, 3/8, 5/8, 7/8, and an edge on a sample leaves it out;
# shared ones about the edges at -1/4, 1/4, 3/4, 5/4, so pixels beside get some too.
p='0 1 255 255 255 255 0 0'
third='tri 256 -65536 '"$p"'  352 -65536 '"$p"'  352 65536 '"$p"'\ntri 256 -65536 '"$p"'  352 65536 '"$p"'  256 65536 '"$p"'\n'
sampled() { draws "$1" "scene 3 1\nfrac 8\nantialias $1\n$third" "$2"; }
sampled none '000000000000'
sampled 'ssaa 2' '000010840000'       # 1/2
sampled 'ssaa 4' '000008420000'       # 1/4
sampled msaa '000008420000'           # 1/4
sampled 'accumulate 4' '000008420000' # 1/4
sampled shared '084208420000'         # 1/4 and 1/4
draws 'whole pixels stay whole' 'scene 3 1\nantialias msaa\npoint 1 0 255 255 255\n' '0000ffff0000'
draws 'whole pixels are n x n' 'scene 3 1\nantialias ssaa 3\npoint 1 0 255 255 255\n' '0000ffff0000'
draws 'smooth shapes in a column more' \
    'scene 3 1\nantialias shared\nsmooth 255 ellipse 1 0 9 9 255 255 255\nsoft 255 disc 1 0 9 255 0 0\n' \
    '00f800f800f8'
draws 'the last counts' "scene 3 1\nfrac 8\nantialias msaa\nantialias none\n$third" '000000000000'
draws 'average' 'scene 3 1\nfilter average\npoint 1 0 255 255 255\n' 'aa52aa52aa52'
draws 'none' 'scene 3 1\nfilter average\nfilter none\npoint 1 0 255 255 255\n' '0000ffff0000'
draws 'kernel' 'scene 3 1\nfilter kernel 0 0 0 0 0 1 0 0 0 1 0\npoint 1 0 255 255 255\n' \
    'ffff00000000'
whole=$(printf '%s' "$third" | sed 's/352/512/g')
draws 'motion without blur' "scene 3 1\nfrac 8\nmotion 1 0\n$whole" '0000ffff0000'
draws 'motion at one moment of two' "scene 3 1\nfrac 8\nmotionblur 2\nmotion 2 0\n$whole" '000010841084'
draws 'exchange' 'scene 4 1\npoint 0 0 255 255 255\npoint 3 0 255 0 0\nexchange 0 0 2 1 2\n' \
    '000000f8ffff0000'

# Every pass gives the same in strips, through ports and in both byte orders, and leaves the planes.
planes() {
    for format in rgb565 rgb565_swapped; do
        printf "scene 21 17\nformat $format\n$1\n$2" >"$out/pass.scene"
        sim "$out/pass.scene" --raw "$out/p.565" --depth "$out/p.z16" || fail "$1"
        [ $format = rgb565 ] && cp "$out/p.565" "$out/first.565"
        same "$1: $format" "$out/p.565" "$out/first.565"
        for options in '--strip 1' '--strip 4' '--port strips1 --strip 16'; do
            # shellcheck disable=SC2086
            sim "$out/pass.scene" $options --raw "$out/o.565" --depth "$out/o.z16" || fail "$1"
            same "$1 $options: colours" "$out/p.565" "$out/o.565"
            same "$1 $options: depths" "$out/p.z16" "$out/o.z16"
        done
    done
}
shapes='clear 20 60 200\nstate ztest less\nfrac 4\ntexture 2 2 ff0000ff 00ff00ff 0000ffff ffffffff\n'
shapes=$shapes'tri 10 20 900 1 255 0 0 255 0 0  300 40 60000 1 0 255 0 255 0 0  60 260 9 1 0 0 255 255 0 0\n'
shapes=$shapes'motion 3 1\nctri -0.5 -0.9 0.5 1 9 9 9 255 0 0 0.9 -0.5 0 1 250 9 9 255 0 0 -0.2 0.9 0 1 9 250 9 255 0 0\n'
shapes=$shapes'disc 5 5 3 255 255 0\nstate scissor 2 3 15 11\nclear 90 90 90\nstate tex replace\n'
shapes=$shapes'tri 40 20 30000 1 0 0 0 255 0 0  300 90 30 2 0 0 0 255 4 0  90 260 9 1 0 0 0 255 0 4\n'
for pass in 'antialias none' 'antialias ssaa 2' 'antialias ssaa 3' 'antialias msaa' \
    'antialias shared' 'antialias accumulate 8' 'antialias fxaa' 'filter sobel' \
    'antialias fxaa\nfilter blur' 'antialias msaa\nmotionblur 3\nfilter average'; do
    planes "$pass" "$shapes"
done
planes 'antialias shared' 'fillpolygon inversion 7 2 115 16 -4 25 2221 2 7 237 250 27 140\n'
