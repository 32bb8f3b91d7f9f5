#!/usr/bin/env python3
"""Writes pictures that scenes draw, from nothing but this program: no photograph, no licence but etch's.

    pictures.py DIRECTORY

lake.ppm    120 x 160, a lake at dusk: "a photo" for menus
button.ppm  24 x 20, a frame for nine-patches; outside its corners pure magenta
arrow.ppm   11 x 17, a cursor in black and white
gauge.ppm   48 x 48, a needle in 12 colours on magenta
"""
import math
import os
import random
import sys


def write(name, width, height, pixel):
    rows = bytes(max(0, min(255, round(c))) for y in range(height) for x in range(width)
                 for c in pixel(x, y))
    with open(os.path.join(sys.argv[1], name), "wb") as f:
        f.write(f"P6\n{width} {height}\n255\n".encode() + rows)


def noise(seed, period):
    """Smooth values 0 .. 1 along a line."""
    values = [random.Random(seed * 1009 + i).random() for i in range(400 // period + 3)]

    def at(x):
        i, t = int(x // period), x / period - x // period
        t = t * t * (3 - 2 * t)
        return values[i] * (1 - t) + values[i + 1] * t
    return at


def ridge(seed, base, height):
    octaves = [(noise(seed + k, max(3, 48 >> k)), 0.5 ** k) for k in range(5)]
    return [base - height * sum(n(x) * w for n, w in octaves) / 1.94 for x in range(120)]


def mix(a, b, t):
    t = max(0.0, min(1.0, t))
    return tuple(p * (1 - t) + q * t for p, q in zip(a, b))


SHORE = 92
RIDGES = [(ridge(3, 84, 44), (122, 112, 150), (196, 150, 158)),
          (ridge(11, 90, 34), (66, 74, 110), (140, 116, 140)),
          (ridge(29, 93, 20), (24, 40, 52), (52, 62, 78))]
TREES = random.Random(5)
FIRS = [(TREES.uniform(0, 120), TREES.uniform(6, 15)) for _ in range(46)]


def sky(x, y):
    low = mix((44, 62, 122), (250, 176, 108), (y / 74) ** 1.25)
    sun = math.hypot(x - 82, (y - 52) * 1.02)
    low = mix(low, (255, 226, 160), 1 - sun / 46)
    streak = noise(int(y / 3) + 71, 24)(x + y) * math.exp(-((y - 34) / 13) ** 2)
    low = mix(low, (255, 196, 170), 0.55 * max(0.0, streak - 0.3))
    return (255, 246, 214) if sun < 7.5 else low


def land(x, y):
    color = sky(x, y)
    for line, near, far in RIDGES:
        depth = y - line[int(x) % 120]
        if depth >= 0:
            color = mix(far, near, depth / 26 + 0.18 * noise(int(y * 3) + 7, 5)(x))
        elif depth > -1:
            color = mix(color, far, 1 + depth)
    for at, tall in FIRS:
        up = SHORE + 1 - y
        if 0 <= up < tall and abs(x - at) < (tall - up) * 0.24 * (0.75 + 0.25 * (int(up * 2) % 3)):
            color = mix((12, 26, 30), (28, 46, 44), up / tall)
    return color


def lake(x, y):
    if y < SHORE:
        return land(x, y)
    deep = y - SHORE
    wave = noise(y * 7 + 1, 5 + deep // 9)(x * 1.5)
    sway = (wave - 0.5) * (1 + deep * 0.09)
    mirror = land(min(119, max(0, x + sway)), max(0, SHORE - 1 - deep * 1.2 + sway))
    color = mix(mirror, (18, 34, 62), 0.24 + deep / 190)
    if wave > 0.8 and deep > 3:
        color = mix(color, (255, 214, 160), (wave - 0.8) * 1.6)
    return color if deep > 0 else (30, 42, 50)


def button(x, y):
    dx = max(6 - x, x - 17, 0)
    dy = max(6 - y, y - 13, 0)
    far = math.hypot(dx, dy)
    if far > 6.3:
        return 255, 0, 255
    if far > 5.0:
        return 20, 24, 40
    if far > 3.9:
        return (150, 190, 240) if y < 10 else (40, 60, 110)
    return mix((86, 128, 200), (52, 82, 150), y / 19)


ARROW = ("#          ", "##         ", "###        ", "####       ", "#####      ", "######     ",
         "#######    ", "########   ", "#########  ", "########## ", "###########", "#######    ",
         "### ###    ", "##  ####   ", "#    ###   ", "     ####  ", "      ##   ")


def arrow(x, y):
    return (255, 255, 255) if ARROW[y][x] == "#" else (0, 0, 0)


def gauge(x, y):
    u, v = x - 23.5, y - 23.5
    across, along = abs(u), 23.5 - v
    wide = 4.6 - 4.0 * along / 23
    if math.hypot(u, v) < 5.2:
        return mix((220, 224, 232), (90, 98, 116), (math.hypot(u + 2, v + 2)) / 7 // 0.25 * 0.25)
    if 1 <= along <= 23 and across < wide:
        return (255, 92, 60) if u < 0 else (190, 40, 30)
    return 255, 0, 255


write("lake.ppm", 120, 160, lake)
write("button.ppm", 24, 20, button)
write("arrow.ppm", 11, 17, arrow)
write("gauge.ppm", 48, 48, gauge)
