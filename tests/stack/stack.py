#!/usr/bin/env python3
"""stack.py GRAPHS BUDGETS TABLE: worst-case stack of the public functions of core and hal, from the
frames and calls that gcc writes beside its objects (-fcallgraph-info=su: GRAPHS/**/*.ci).

Functions that a caller gives (a kernel, a painter, a vertex function, a sink ..) take stack of their
own, and the same function takes any of them. So a function has two figures: `alone`, with nothing of
the caller's counted, and `under`, what stands on the stack below the deepest call of the caller's
function. The whole is the greater of `alone` and `under` + the given function's `alone`.

A call through a pointer is looked up by the last name of the expression that is called. POINTERS says
what may stand there: USER, a function of the caller's; else those of a function type, or those whose
names fit, of which the deepest counts. A name with a file in front is of the calls in that file; a table
says by callers what these put there, and a caller that it does not know any of that. A pointer that no list knows is an error, so that nothing new
goes uncounted. A function stands on the stack once, or as often as RECURSION says. libgcc's division
takes LIBGCC bytes at most and may be called by any function: it is in every figure.

BUDGETS has lines of two kinds, of names that may have *:
    BYTES alone NAME ..                   both figures of functions by themselves; the last line counts
    BYTES POINTER=NAMES .. NAME ..        the whole, with these functions behind the pointers
Prints the whole and fails where something exceeds its budget or a name fits no function; writes
all figures to TABLE."""
import fnmatch
import glob
import re
import sys

LIBGCC = 24
USER = "user"
POINTERS = {  # name: USER, a function type, or names of functions
    "kernel": USER, "vertex": USER, "painter": USER, "triangle": USER, "line": USER, "point": USER,
    "run": USER, "shade": USER, "kind": USER, "filter": USER, "wrap_u": USER, "wrap_v": USER,
    "colors": USER, "alphas": USER, "function": USER, "color": USER, "value": USER, "varying": USER,
    "operation": USER, "pause": USER, "flush": USER, "wait": USER, "sync": USER, "memory": USER,
    "start": USER, "next": USER, "kern": USER, "take": USER, "enter": USER, "leave": USER,
    "signal": USER, "cap": USER, "join": USER, "edge": USER, "inner": USER, "record": USER, "decode": USER, "runs": USER,
    "core/draw/*:row": USER,
    "core/raster/rows*:row": {"etch_stretched_*": ["core/raster/stretched.c:*"], "etch_ring_*": ["etch_ring_spans"],
                              "etch_arc_line_*": ["core/raster/arc_line.c:*"], "etch_arc_*": ["etch_arc_spans"]},
    "core/raster/smooth_lines.c:line": {
        "etch_smooth_arc": ["core/raster/smooth_arc.c:line"], "etch_smooth_line_*": ["core/raster/smooth_line_round.c:line"],
        "etch_smooth_round_*": ["core/raster/smooth_round_rect.c:inside", "core/raster/smooth_round_rect.c:frame"],
        "etch_smooth_*": ["core/raster/smooth_ring.c:line"]},
    "copy": ["core/draw/rle_*.c:*"], "row": "etch_polygon_row", "span": "etch_span", "side": ["etch_implicit_side_*"],
}
RECURSION = {"draw_tile": 8}


class Graph:
    def __init__(self, names):
        """From these .ci files."""
        self.frame, self.calls, self.by_caller = {}, {}, set()
        for name in names:
            with open(name, encoding="utf8") as f:
                text = f.read()
            for m in re.finditer(r'node: \{ title: "([^"]+)" label: "[^"]*?(\d+) bytes \((\w+)\)', text):
                if m[3] != "static":
                    sys.exit(f"{m[1]}: the size of its frame is not constant")
                self.frame[m[1]] = int(m[2])
            edges = re.findall(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"'
                               r'(?: label: "([^"]+)")? \}', text)
            if len(edges) != text.count("edge: {"):
                sys.exit(f"{name}: not all calls could be read")
            for source, target, place in edges:  # a call of what gcc split off has no place
                self.calls.setdefault(source, set()).add((target, place))
        if not self.frame:
            sys.exit("no call graphs")
        self.source = {f: open(f, encoding="utf8").read() for f in
                       sorted(glob.glob("core/**/*.[ch]", recursive=True) +
                              glob.glob("hal/**/*.[ch]", recursive=True))}
        self.texts = "\n".join(self.source.values())
        self.choose({})

    def choose(self, chosen):
        """What stands behind pointers from now on, where it is not POINTERS'."""
        self.chosen, self.known = chosen, {}

    def named(self, pattern):
        found = [f for f in self.frame if fnmatch.fnmatch(f, pattern)]
        return found or sys.exit(f"no function fits {pattern}")

    def of_type(self, kind):
        found = set(re.findall(rf"\b{kind} (\w+)[;,\s]", self.texts))
        return [f for f in self.frame if f.split(":")[-1] in found]

    def called(self, place):
        """The last name of the expression that is called at FILE:LINE:COLUMN."""
        path, line, column = place.rsplit(":", 2)
        if path not in self.source:
            with open(path, encoding="utf8") as f:
                self.source[path] = f.read()
        text = self.source[path].split("\n")[int(line) - 1][int(column) - 1:]
        m = re.match(r"\W*(\w+)\)?\(", text) or re.search(r"(?:->|\.)(\w+)\(", text)
        return m[1] if m else sys.exit(f"{place}: a call that cannot be read: {text}")

    def pointer(self, place, way):
        """The functions of an indirect call, or USER; `way` leads there."""
        name, path = self.called(place), place.split(":")[0]
        if name not in POINTERS:
            sys.exit(f"{place}: a call through an unknown pointer, {name}")
        here = [v for k, v in POINTERS.items() if ":" in k and fnmatch.fnmatch(f"{path}:{name}", k)]
        what = here[0] if here else POINTERS[name]
        if not here or what == USER:
            what = self.chosen.get(name, what)
        if isinstance(what, dict):
            self.by_caller.add(way[-1])
            fits = [v for k, v in what.items() if any(fnmatch.fnmatch(f, k) for f in way)]
            what = fits[0] if fits else sum(what.values(), [])
        if what == USER:
            return [USER]
        if isinstance(what, str):
            return self.of_type(what)
        return [f for p in what for f in self.named(p)]

    def callees(self, way):
        found = set()
        for target, place in self.calls.get(way[-1], []):
            found |= set(self.pointer(place, way)) if target == "__indirect_call" else {target}
        return sorted(found)

    def depth(self, name, path=()):
        """(alone, under, the way down): `under` is 0 where nothing of the caller's is called."""
        if name == USER:
            return 0, 1, ()
        if path.count(name) >= RECURSION.get(name.split(":")[-1], 1) or name not in self.frame:
            return 0, 0, ()
        if name in self.known:
            return self.known[name]
        frame, alone, under, way = self.frame[name], 0, 0, ()
        for a, u, w in (self.depth(c, path + (name,)) for c in self.callees(path + (name,))):
            under = max(under, u)
            alone, way = max((alone, way), (a, w))
        result = frame + alone, under and frame + under, (name,) + way
        if name not in self.by_caller and \
                not any(p in RECURSION for p in (f.split(":")[-1] for f in path + (name,))):
            self.known[name] = result
        return result


def whole_lines(graph, lines):
    """Prints the functions with what a line puts behind their pointers. Returns failures, lines."""
    failed = 0
    print("| function | with | stack, bytes | budget |\n|---|---|--:|--:|")
    for budget, words in lines:
        chosen = dict(w.split("=") for w in words if "=" in w)
        graph.choose({k: [v] for k, v in chosen.items()})
        names = [f for w in words if "=" not in w for f in graph.named(w) if ":" not in f]
        for size, way, name in sorted(((d[0] + LIBGCC, d[2], f) for f in names
                                       for d in [graph.depth(f)]), reverse=True):
            over = size > budget
            failed += over
            given = ", ".join(f"`{v.split('/')[-1]}`" for k, v in chosen.items() if k != "span")
            print(f"| `{name}` | {given} | {size} | {budget}{' **over**' if over else ''} |")
            if over:
                print("    " + " > ".join(f"{f.split(':')[-1]} {graph.frame[f]}" for f in way),
                      file=sys.stderr)
    graph.choose({})
    return failed


def alone(graph, lines, table):
    """All public functions by themselves, to `table`. Returns failures."""
    figures, budget, failed = {}, {}, 0
    for f in graph.frame:
        if ":" not in f:
            a, u, way = graph.depth(f)
            figures[f] = a + LIBGCC, max(u - 1, 0), way
    for size, words in lines:
        for f in (f for w in words for f in graph.named(w)):
            budget[f] = size
    for f, (a, u, way) in figures.items():
        if max(a, u) > budget.get(f, 0):
            failed += 1
            print(f"{f}: {a} alone, {u} under the caller's, budget {budget.get(f, 0)}\n    " +
                  " > ".join(f"{g.split(':')[-1]} {graph.frame[g]}" for g in way), file=sys.stderr)
    with open(table, "w", encoding="utf8") as out:
        step = [0, 64, 128, 192, 256, 384, 512, 768, 1024, 4096]
        for low, high in zip(step, step[1:]):
            rows = sorted((-a, f.removeprefix("etch_"), u) for f, (a, u, _) in figures.items()
                          if low < a <= high)
            if rows:
                out.write(f"**{low + 1} .. {high}** ({len(rows)}): " +
                          ", ".join(f"{f} {-a}" + (f" ({u})" if u else "") for a, f, u in rows) +
                          ".\n\n")
    return failed, len(figures)


def main():
    folder, budgets, table = sys.argv[1:]
    names = sorted(glob.glob(folder + "/**/*.ci", recursive=True))
    graph, whole, single = Graph(names), [], []
    with open(budgets, encoding="utf8") as f:
        for words in (line.split("#")[0].split() for line in f):
            if words[1:2] == ["alone"]:
                single.append((int(words[0]), words[2:]))
            elif words:
                whole.append((int(words[0]), words[1:]))
    failed, count = alone(graph, single, table)
    failed += whole_lines(graph, whole)
    print(f"{count} public functions, worst-case stack on Cortex-M0+: all figures in {table}")
    print(f"{count + len(whole) - failed} passed, {failed} failed")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
