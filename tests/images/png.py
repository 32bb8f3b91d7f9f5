#!/usr/bin/env python3
"""PNG files give what the same pictures give as PPM and PGM. Called by `make images-png` with BUILD
set; etch-image must have been built with libpng."""
import os
import random
import struct
import subprocess
import sys
import zlib

build = os.environ.get("BUILD", "build")
out = os.path.join(build, "images-png")
os.makedirs(out, exist_ok=True)
passed = failed = 0


def check(ok, what):
    global passed, failed
    passed, failed = passed + ok, failed + (not ok)
    if not ok:
        print("FAIL", what)


def path(name):
    return os.path.join(out, name)


def tool(*arguments):
    run = subprocess.run([os.path.join(build, "etch-image"), *arguments], capture_output=True)
    return run.returncode, run.stdout, run.stderr.decode()


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(name, kind, channels, extra=b""):
    """kind: the colour type of PNG; rows without a filter."""
    data = b"".join(b"\0" + bytes(sum((list(p[:channels]) for p in row), [])) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, kind, 0, 0, 0)
    with open(path(name), "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + extra +
                chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))


random.seed(1)
rows = [[tuple(random.randrange(256) for _ in range(4)) for _ in range(13)] for _ in range(9)]
with open(path("a.ppm"), "wb") as f:
    f.write(b"P6 13 9 255\n" + bytes(c for row in rows for p in row for c in p[:3]))
with open(path("a.pgm"), "wb") as f:
    f.write(b"P5 13 9 255\n" + bytes(p[3] for row in rows for p in row))
png("rgba.png", 6, 4)
png("rgb.png", 2, 3)

plain = path("a.ppm")
for form in ("rgb565", "index4", "index2_key", "mask8"):
    check(tool("-f", form, path("rgb.png")) == tool("-f", form, plain), "RGB as " + form)
for form in ("rgb565_alpha", "rgb565_key", "index8_key", "index8", "rgb565", "mask8", "mask4"):
    status, c, said = tool("-f", form, path("rgba.png"))
    check(status == 0 and (status, c, said) == tool("-f", form, "-a", path("a.pgm"), plain),
          "RGBA as " + form + ": " + said)

rows = [[(i % 3, 0, 0, 0) for i in range(13)] for _ in range(9)]
png("palette.png", 3, 1, chunk(b"PLTE", bytes([255, 0, 0, 0, 255, 0, 8, 16, 24])))
with open(path("p.ppm"), "wb") as f:
    f.write(b"P6 13 9 255\n" +
            b"".join([b"\xff\0\0", b"\0\xff\0", b"\x08\x10\x18"][p[0]] for row in rows for p in row))
check(tool("-f", "index2", path("palette.png")) == tool("-f", "index2", path("p.ppm")), "a palette")

whole = open(path("rgba.png"), "rb").read()
for size in range(3, len(whole) - 12, 37):
    with open(path("cut.png"), "wb") as f:
        f.write(whole[:size])
    status, c, said = tool("-f", "rgb565", path("cut.png"))
    check(status == 2 and c == b"" and "PNG" in said, f"cut at {size}: {status} {said}")
for i in range(40):
    spoilt = bytearray(whole)
    spoilt[random.randrange(8, len(whole))] ^= 1 << random.randrange(8)
    with open(path("spoilt.png"), "wb") as f:
        f.write(spoilt)
    status, c, said = tool("-f", "rgb565", path("spoilt.png"))
    check(status in (0, 2) and (status == 0) == (c != b""), f"spoilt: {status} {said}")

print(f"{passed} passed, {failed} failed")
sys.exit(failed != 0)
