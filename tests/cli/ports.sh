# tests/cli: panels as ports: the frame through the driver, the bus and the simulated panel is the
# frame drawn directly. Sourced by run.

# A scene of the size that a port shows, turned or not; drawn in black and white alone for panels
# that show no colours: these two are not dithered.
panel_scene() { # WIDTH HEIGHT COLOURS
    printf 'scene %d %d\nclear %s\ndisc %d 30 25 %s\n' "$1" "$2" '0 0 0' $(($1 / 2)) '255 255 255'
    printf 'line 0 0 %d %d 255 255 255\n' $(($1 - 1)) $(($2 - 1))
    if [ "$3" = yes ]; then
        printf 'rect 3 5 20 9 255 0 0\nfillrect 9 20 40 5 9 130 77\nstate ztest less\n'
        printf 'tri 0 0 9 1 255 0 0 255 0 0  90 5 60000 1 0 255 0 255 0 0  %s\n' \
            '0 50 30000 1 0 0 255 255 0 0'
        printf 'texture 2 1 FF0000FF 0000FFFF\nstate tex replace\n'
        printf 'tri 40 0 9 1 255 0 0 255 0 0  90 5 9 1 0 0 0 255 9 0  60 40 9 1 0 0 0 255 0 9\n'
    fi
}

panels=$(sim --help | sed -n 's/^ *ports: *memory strips strips1 //p')
[ "$(echo "$panels" | wc -w)" -ge 14 ] && pass || fail "--help lists the ports: $panels"
printf 'scene 1 1\n' >"$out/one.scene"
for panel in $panels; do
    sim "$out/one.scene" --port "$panel" >"$out/stdout" 2>&1
    size=$(sed -n "s/.*$panel shows \([0-9]*\) x \([0-9]*\), or .* on its side, and not 1 x 1/\1 \2/p" \
        "$out/stdout")
    colours=yes
    case $panel in ssd1306* | ssd0323) colours=no ;; esac
    # shellcheck disable=SC2086
    set -- $size
    [ $# -eq 2 ] && pass || fail "$panel: no size in $(cat "$out/stdout")"
    panel_scene "$1" "$2" $colours >"$out/upright.scene"
    panel_scene "$2" "$1" $colours >"$out/side.scene"
    for which in upright side; do
        sim "$out/$which.scene" --raw "$out/o.565" --depth "$out/o.z16" || fail "$panel: $which"
        odd=0
        [ $which = side ] && [ "$1" -ne "$2" ] && odd=1
        for options in '' "--turn $((odd + 2)) --buffers 1" "--turn $odd --mirror xy --strip 5" \
            '--strip 32767 --clock 1000000 --lanes 8'; do
            # shellcheck disable=SC2086
            sim "$out/$which.scene" --port "$panel" $options --raw "$out/p.565" \
                --depth "$out/p.z16" || fail "$panel $which $options"
            same "$panel $which $options: colours" "$out/o.565" "$out/p.565"
            same "$panel $which $options: depths" "$out/o.z16" "$out/p.z16"
        done
    done
done

# The byte order is the panel's, whatever the scene says; so are strips of 16 rows without another.
panel_scene 128 160 yes >"$out/plain.scene"
{ cat "$out/plain.scene" && echo 'format rgb565_swapped' && echo 'strip 3'; } >"$out/swapped.scene"
sim "$out/plain.scene" --raw "$out/o.565" -o "$out/o.png" || fail 'plain'
sim "$out/swapped.scene" --port st7735-red --raw "$out/p.565" -o "$out/p.png" || fail 'swapped'
same 'a panel of a swapped scene: colours' "$out/o.565" "$out/p.565"
same 'a panel of a swapped scene: picture' "$out/o.png" "$out/p.png"

# A grey is dithered where the panel has black and white alone, and what is shown is written.
printf 'scene 128 64\nclear 128 128 128\n' >"$out/grey.scene"
sim "$out/grey.scene" --port ssd1306 -o "$out/p.ppm" || fail 'grey'
tail -c 24576 "$out/p.ppm" | od -An -v -tx1 | tr -s ' ' '\n' | sort -u | tr -d '\n' >"$out/stdout"
[ "$(cat "$out/stdout")" = 00ff ] && pass || fail "black and white are $(cat "$out/stdout")"

# What went over the bus, and how long that takes: 15 windows of 11 bytes, 8 bits a byte.
printf 'scene 320 240\nclear 1 2 3\n' >"$out/quarter.scene"
sim "$out/quarter.scene" --port ili9341 --stats >"$out/stdout" || fail 'stats of a panel'
has 'port       ili9341, turn 1, strips from two buffers'
has 'flushed    153765 bytes in 15 transactions'
has 'commands   165 bytes beside 153600 of pixels'
has 'bus        30.753 ms at 40000000 Hz, 1 bit wide'
has 'ram        20480 bytes: colour 20480, depth 0, vertices 0'
sim "$out/quarter.scene" --port ili9341 --stats --clock 10000000 --lanes 8 --strip 240 --buffers 1 \
    >"$out/stdout" || fail 'stats of a parallel panel'
has 'port       ili9341, turn 1, strips from one buffer'
has 'bus        15.361 ms at 10000000 Hz, 8 bits wide'
sim "$out/grey.scene" --port ssd1306 --needs >"$out/stdout" || fail 'needs of a panel'
has 'ram        4096 bytes a colour buffer of 16 rows.*'

q=$out/quarter.scene
rejects 'a size' "^$q:0: ssd1306 shows 128 x 64, or 64 x 128 on its side, and not 320 x 240" \
    "$q" --port ssd1306 -o "$out/o.png"
rejects 'a turn' "^$q:0: ili9341 does not show 320 x 240 at turn 2" "$q" --port ili9341 --turn 2
rejects 'a wrong turn' '^etch-sim: --turn takes .* not 4' "$q" --port ili9341 --turn 4
rejects 'a wrong mirror' '^etch-sim: --mirror takes .* not z' "$q" --port ili9341 --mirror z
rejects 'wrong buffers' '^etch-sim: --buffers takes .* not 3' "$q" --port ili9341 --buffers 3
rejects 'a wrong clock' '^etch-sim: --clock takes .* not 40MHz' "$q" --port ili9341 --clock 40MHz
rejects 'wrong lanes' '^etch-sim: --lanes takes .* not 9' "$q" --port ili9341 --lanes 9
rejects 'no panel' '^etch-sim: only panels take --turn' "$q" --port strips --turn 1
rejects 'no port' '^etch-sim: only panels take --turn' "$q" --clock 1
