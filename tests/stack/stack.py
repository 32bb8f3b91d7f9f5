#!/usr/bin/env python3
"""stack.py GRAPHS BUDGETS: worst-case stack of the public functions of core and hal, from the frames
and calls that gcc writes beside its objects (-fcallgraph-info=su: GRAPHS/**/*.ci).

A call through a pointer counts as the deepest of the library's own functions that may stand there.
POINTERS says which, by the last name of the expression that is called: those of a function type,
those whose names fit, or none: then it is a function of the caller's own, which comes on top. A
function stands on the stack once, or as often as RECURSION says. A pointer that no list knows is an
error, so that nothing new goes uncounted. libgcc's division takes LIBGCC bytes at most and may be
called by any function.

BUDGETS has lines "BYTES  POINTER=NAMES ..  NAME .."; names may have *. POINTER=NAMES restricts what
stands behind a pointer for this line, since a caller chooses it. Prints a table of these functions, deepest
first in each line's group, and fails where one exceeds its budget or fits no function."""
import fnmatch
import functools
import glob
import re
import sys

LIBGCC = 24
USER = []
POINTERS = {  # name: a function type, or names of functions
    "kernel": "etch_kernel", "vertex": "etch_vertex_function", "inner": "etch_vertex_function",
    "run": "etch_stage_function", "shade": "etch_shade_function", "kind": "etch_lamp_function",
    "filter": "etch_texel_filter", "wrap_u": "etch_texel_wrap", "wrap_v": "etch_texel_wrap",
    "colors": "etch_texel_colors", "alphas": "etch_texel_alphas", "varying": "etch_varying",
    "runs": "etch_point_runs", "row": "etch_polygon_row", "span": "etch_span",
    "operation": ["etch_stencil_*"],
    "painter": ["etch_triangle_*", "etch_multisample_*", "etch_shared_*"],
    "triangle": ["core/draw/*sink*.c:*", "core/draw/retained*.c:*", "core/frame/*sink.c:*"],
    "line": ["core/draw/*sink*.c:*", "core/frame/*sink.c:*"],
    "point": ["core/draw/*sink*.c:*", "core/frame/*sink.c:*"],
    "function": USER, "color": USER, "value": USER, "side": ["etch_implicit_side_*"],
    "pause": USER, "flush": USER, "wait": USER, "sync": USER, "memory": USER, "start": USER,
    "next": USER,
}
RECURSION = {"draw_tile": 8}


def functions_of_type(kind, frames, sources):
    """Names that headers and files declare with a function type."""
    found = re.findall(rf"\b{kind} (\w+)[;,\s]", sources)
    if kind == "etch_kernel":
        found += re.findall(r"ETCH_\w*KERNEL\w*\((?:static )?(\w+)", sources)
    return [f for f in frames if f.split(":")[-1] in set(found)]


class Graph:
    def __init__(self, folder):
        self.frame, self.calls, self.source = {}, {}, {}
        for name in sorted(glob.glob(folder + "/**/*.ci", recursive=True)):
            with open(name, encoding="utf8") as f:
                text = f.read()
            for m in re.finditer(r'node: \{ title: "([^"]+)" label: "[^"]*?(\d+) bytes \((\w+)\)', text):
                if m[3] != "static":
                    sys.exit(f"{m[1]}: the size of its frame is not constant")
                self.frame[m[1]] = int(m[2])
            for m in re.finditer(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)" label: "([^"]+)"',
                                 text):
                self.calls.setdefault(m[1], []).append((m[2], m[3]))
        self.chosen = {}
        self.texts = "\n".join(open(f, encoding="utf8").read() for f in
                               glob.glob("core/**/*.[ch]", recursive=True))

    def candidates(self, name):
        what = self.chosen.get(name, POINTERS[name])
        if isinstance(what, str):
            return functions_of_type(what, self.frame, self.texts)
        return [f for f in self.frame for p in what if fnmatch.fnmatch(f, p)]

    def pointer(self, place):
        """The candidates of an indirect call at FILE:LINE:COLUMN."""
        path, line, column = place.rsplit(":", 2)
        with open(path, encoding="utf8") as f:
            text = f.read().split("\n")[int(line) - 1][int(column) - 1:]
        m = re.search(r"(?:->|\.)(\w+)\(", text) or re.match(r"\(?\*?(\w+)\)?\(", text)
        if not m or m[1] not in POINTERS:
            sys.exit(f"{place}: a call through an unknown pointer: {text}")
        return self.candidates(m[1])

    def callees(self, name):
        found = set()
        for target, place in self.calls.get(name, []):
            found |= set(self.pointer(place)) if target == "__indirect_call" else {target}
        return sorted(found)

    def depth(self, name, path=()):
        """Stack below and with `name`, and the way down."""
        if path.count(name) >= RECURSION.get(name.split(":")[-1], 1) or name not in self.frame:
            return 0, ()
        best = (0, ())
        for callee in self.callees(name):
            best = max(best, self.depth(callee, path + (name,)))
        return self.frame[name] + best[0], (name,) + best[1]


def main():
    graph = Graph(sys.argv[1])
    failed = 0
    print("| function | stack, bytes | budget |\n|---|--:|--:|")
    for line in open(sys.argv[2], encoding="utf8"):
        words = line.split("#")[0].split()
        rows = []
        graph.chosen = {w.split("=")[0]: [w.split("=")[1]] for w in words if "=" in w}
        for pattern in (w for w in words[1:] if "=" not in w):
            names = [f for f in graph.frame if ":" not in f and fnmatch.fnmatch(f, pattern)]
            if not names:
                sys.exit(f"{sys.argv[2]}: no function {pattern}")
            rows += [(graph.depth(f), f) for f in names]
        for (size, way), name in sorted(rows, reverse=True):
            over = size + LIBGCC > int(words[0])
            failed += over
            print(f"| `{name}` | {size + LIBGCC} | {words[0]}{' **over**' if over else ''} |")
            if over:
                print("    " + " > ".join(f"{f.split(':')[-1]} {graph.frame[f]}" for f in way),
                      file=sys.stderr)
    print(f"{'0 passed, 1' if failed else '1 passed, 0'} failed", file=sys.stderr)
    sys.exit(failed != 0)


main()
