#!/usr/bin/env python3
"""qemu_screen.py SCALE QEMU .. ELF: runs a firmware until it says "drawn", takes QEMU's picture of
the screen, and writes it as big-endian RGB565. SCALE: screen pixels to a pixel of the display, which
must all be equal."""
import json
import os
import socket
import subprocess
import sys
import tempfile

LIMIT_S = 120


def run(command, folder):
    path = os.path.join(folder, "qmp")
    picture = os.path.join(folder, "screen.ppm")
    environment = dict(os.environ, QEMU_AUDIO_DRV="none")
    qemu = subprocess.Popen(
        ["timeout", str(LIMIT_S)] + command +
        ["-display", "none", "-monitor", "none", "-serial", "null", "-qmp",
         f"unix:{path},server=on,wait=off"],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)
    said = b""
    while b"drawn\n" not in said:
        line = qemu.stdout.readline()
        if not line or b"FAIL" in line:
            qemu.kill()
            sys.exit(f"the firmware did not draw: {said + line!r}")
        said += line
    with socket.socket(socket.AF_UNIX) as s:
        s.connect(path)
        stream = s.makefile("rwb")
        stream.readline()
        for request in ({"execute": "qmp_capabilities"},
                        {"execute": "screendump", "arguments": {"filename": picture}},
                        {"execute": "quit"}):
            stream.write(json.dumps(request).encode() + b"\n")
            stream.flush()
            while "event" in (answer := json.loads(stream.readline())):
                pass
            if "error" in answer:
                sys.exit(str(answer))
    qemu.wait()
    with open(picture, "rb") as f:
        return f.read()


def pixels(ppm, scale):
    magic, size, _, data = ppm.split(b"\n", 3)
    width, height = map(int, size.split())
    if magic != b"P6" or width % scale or height % scale:
        sys.exit(f"a screen of {width} x {height} is not {scale} to a pixel")
    rows = [data[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    for y in range(0, height, scale):
        if any(rows[y + i] != rows[y] for i in range(scale)):
            sys.exit(f"rows {y} .. differ")
        for x in range(0, width, scale):
            r, g, b = rows[y][3 * x:3 * x + 3]
            if rows[y][3 * x:3 * (x + scale)] != bytes((r, g, b)) * scale:
                sys.exit(f"columns {x} .. of row {y} differ")
            yield (r >> 3) << 11 | (g >> 2) << 5 | b >> 3


def main():
    with tempfile.TemporaryDirectory() as folder:
        ppm = run(sys.argv[2:], folder)
    out = bytearray()
    for pixel in pixels(ppm, int(sys.argv[1])):
        out += bytes((pixel >> 8, pixel & 255))
    sys.stdout.buffer.write(out)


main()
