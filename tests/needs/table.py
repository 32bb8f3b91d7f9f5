#!/usr/bin/env python3
"""table.py LIB LIBGCC GRAPHS OUT.c: what each part of core and hal weighs on a Cortex-M0+ at -Os, and which others
it calls or reads: the table from which `etch-sim --needs` sums what a program links, as the linker's
--gc-sections would. A part is a section of an object of LIB (compiled with -ffunction-sections), or an object
of LIBGCC. Beside it stand the worst-case stack of a public function alone and what is on the stack under
what the caller gives it (tests/stack)."""
import glob
import os
import re
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../stack"))
from stack import LIBGCC, Graph  # noqa: E402

ALLOC, RELOCATIONS, SYMBOLS, NOTES = 2, 9, 2, 0x70000001


def members(path):
    """The objects of an archive."""
    data, at = open(path, "rb").read(), 8
    while at < len(data):
        name, size = data[at:at + 16].decode().strip(), int(data[at + 48:at + 58])
        if name not in ("/", "//"):
            yield data[at + 60:at + 60 + size]
        at += 60 + size + (size & 1)


def text(data, at):
    return data[at:data.index(b"\0", at)].decode()


def read(data, whole):
    """The parts of an object: [(bytes, names, targets)], a target being a name or a number of this list. Of libgcc's
    objects all sections are one part."""
    offset, count = struct.unpack_from("<I", data, 32)[0], struct.unpack_from("<H", data, 48)[0]
    head = [struct.unpack_from("<10I", data, offset + 40 * i) for i in range(count)]
    kept = [i for i, h in enumerate(head) if h[2] & ALLOC and h[5] and h[1] not in (NOTES, 8)]
    number = {i: 0 if whole else k for k, i in enumerate(kept)}
    parts = [[0, [], set()] for _ in range(1 if whole else len(kept))]
    table = next(h for h in head if h[1] == SYMBOLS)
    symbols = [struct.unpack_from("<IIIBBH", data, table[4] + 16 * i) for i in range(table[5] // 16)]
    names = [text(data, head[table[6]][4] + s[0]) for s in symbols]
    for i in kept:
        parts[number[i]][0] += head[i][5]
    for s, name in zip(symbols, names):
        if s[5] in number and s[3] >> 4 != 0:  # global or weak
            parts[number[s[5]]][1].append(name)
    for h in head:
        if h[1] == RELOCATIONS and h[7] in number:
            for at in range(h[4], h[4] + h[5], 8):
                s = struct.unpack_from("<II", data, at)[1] >> 8
                parts[number[h[7]]][2].add(names[s] if symbols[s][5] == 0 else number.get(symbols[s][5]))
    return parts


def collect(lib, libgcc):
    """[(bytes, names, numbers of parts)] of all that anything in lib can need."""
    parts, where = [], {}
    for path, whole in ((lib, False), (libgcc, True)):
        for data in members(path):
            first = len(parts)
            for size, names, targets in read(data, whole):
                for name in names:
                    where.setdefault(name, len(parts))
                parts.append((size, names, {t if isinstance(t, str) else first + t for t in targets if t is not None}))
    links = [sorted({where[t] if isinstance(t, str) else t for t in targets
                     if not isinstance(t, str) or t in where}) for _, _, targets in parts]
    reached, todo = set(), [i for i, p in enumerate(parts) if any(n.startswith("etch_") for n in p[1])]
    while todo:
        i = todo.pop()
        if i not in reached:
            reached.add(i)
            todo += links[i]
    number = {i: k for k, i in enumerate(sorted(reached))}
    return [(parts[i][0], parts[i][1], [number[t] for t in links[i] if t != i]) for i in sorted(reached)]


def stacks(graphs):
    graph = Graph(sorted(glob.glob(graphs + "/core/**/*.ci", recursive=True) + glob.glob(graphs + "/hal/**/*.ci", recursive=True)))
    found = {}
    for f in graph.frame:
        if ":" not in f:
            alone, under, _ = graph.depth(f)
            found[f] = alone + LIBGCC, max(under - 1, 0)
    return found


def inlined():
    """Functions of the headers that are always inlined: no part of their own."""
    found = set()
    for name in glob.glob("core/*/*.h") + glob.glob("hal/*.h"):
        with open(name, encoding="utf8") as f:
            found |= set(re.findall(r"ETCH_INLINE [^(;{=]*?\b(etch_\w+)\(", f.read()))
    return found


def rows(words, width=100):
    line = "   "
    for w in words:
        if len(line) + 2 + len(w) > width:
            yield line
            line = "   "
        line += f" {w},"
    yield line


def main():
    lib, libgcc, graphs, out = sys.argv[1:]
    parts, stack, links, first = collect(lib, libgcc), stacks(graphs), [], []
    for _, _, targets in parts:
        first.append(len(links))
        links += targets
    named = sorted([(n, i) for i, p in enumerate(parts) for n in p[1] if n.startswith("etch_")] +
                   [(n, len(parts)) for n in inlined()])
    parts.append((0, [], []))
    first.append(len(links))
    version = subprocess.check_output(["arm-none-eabi-gcc", "-dumpversion"], text=True).strip()
    with open(out, "w", encoding="utf8") as f:
        f.write("/* ports/host/needs_table.c: what the parts of core and hal weigh and link; see needs.h. Written by\n"
                f" * `make needs-table` (arm-none-eabi-gcc {version}, Cortex-M0+, -Os); not to be edited. */\n/* clang-format off */\n"
                '#include "needs_table.h"\n\n'
                "const struct etch_needs_part etch_needs_part[] = {\n")
        f.write("\n".join(rows([f"{{{p[0]}, {a}}}" for p, a in zip(parts, first)] + [f"{{0, {len(links)}}}"])))
        f.write("\n};\n\nconst uint16_t etch_needs_link[] = {\n" + "\n".join(rows([str(t) for t in links])))
        f.write("\n};\n\nconst struct etch_needs_name etch_needs_name[] = {\n")
        for n, i in named:
            a, u = stack.get(n, (0, 0))
            f.write(f'    {{"{n}", {i}, {a}, {u}}},\n')
        f.write("};\n"
                f"const size_t etch_needs_part_count = {len(parts)}, etch_needs_name_count = {len(named)};\n")


main()
