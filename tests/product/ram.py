#!/usr/bin/env python3
"""ram.py LIMIT CORE DIR PROGRAM.elf ..: all RAM that programs of a Cortex-M0+ use, in bytes: what the linker put
there (.data, .bss) and the deepest stack. Fails if the sum is above LIMIT.

The stack is that of the call graphs which gcc wrote (CORE/**/*.ci, DIR/board/**/*.ci, DIR/PROGRAM.ci), as in
tests/stack/stack.py; but a program is whole, so behind each pointer stands what it has linked of that
type (BEHIND), and nothing is left to the caller. On top of it one interrupt: all have one priority."""
import fnmatch
import glob
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../stack"))
from stack import LIBGCC, Graph  # noqa: E402

EXCEPTION = 36  # eight words that the core saves, and one to align them
LIBRARY = re.compile(r"__aeabi_|__gnu_thumb1_case_|__u?divsi3|__clzsi2|__ctzsi2")
BEHIND = {  # pointer: function types of core's headers (etch_..), or names of functions
    "kernel": ["etch_kernel", "etch_cover_kernel"],
    "painter": ["etch_glyph_painter"],
    "line": ["core/raster/smooth_*.c:line"],
    "symbol": ["symbol_*"],
    "draw": ["tests/product/{}.c:draw"], "prepare": ["tests/product/{}.c:prepare", "plot_prepare"],
    "write": [], "colors": ["etch_texel_colors", "core/fragment/gradient_linear.c:*"],
    "alphas": ["etch_texel_alphas"], "filter": ["etch_texel_filter"],
    "wrap_u": ["etch_texel_wrap"], "wrap_v": ["etch_texel_wrap"],
    "run": ["etch_stage_function"], "kern": ["etch_font_kern"],
    "edge": ["etch_outline_smooth"], "cap": ["etch_stroke_part"], "join": ["etch_stroke_part"],
    "flush": ["etch_lcd_flush"], "wait": ["etch_lcd_wait", "ports/rp2040/board.c:wait"],
    "begin": ["ports/rp2040/board.c:begin"], "end": ["ports/rp2040/board.c:end"],
    "command": ["ports/rp2040/board.c:command"], "data": ["ports/rp2040/board.c:data"],
    "reset": ["ports/rp2040/board.c:reset"], "delay": ["ports/rp2040/board.c:delay"],
    "turn": ["etch_lcd_orient"], "convert": [], "sync": [], "memory": [],
    "start": ["ports/rp2040/board.c:start_dma"], "next": ["ports/spi_lcd/lcd_pixels.c:*"],
    "record": ["etch_lcd_wait"], # of display->wait(..)
    "pause": ["hal/guarded.c:pause"], "enter": ["ports/rp2040/cores.c:enter"],
    "leave": ["ports/rp2040/cores.c:leave"], "signal": ["ports/rp2040/cores.c:*"],
}


class Program(Graph):
    def __init__(self, names, screen, linked):
        super().__init__(names)
        self.screen, self.linked = screen, linked
        self.choose({})

    def of_type(self, kind):
        lists = re.findall(rf"^{kind} (\w+(?:,\s*\w+)*);", self.texts, re.M)
        return [f for names in lists for f in re.split(r",\s*", names)]

    def pointer(self, place, way):
        name = self.called(place)
        if name not in BEHIND:
            sys.exit(f"{place}: a call through an unknown pointer, {name}")
        found = set()
        for what in BEHIND[name]:
            what = what.format(self.screen)
            found |= set(self.of_type(what) if what.startswith("etch_") and what not in self.frame else
                         fnmatch.filter(self.frame, what))
        found = [f for f in found if f in self.frame and f.split(":")[-1] in self.linked]
        if BEHIND[name] and not found:
            sys.exit(f"{place}: nothing stands behind {name}")
        return found

    def callees(self, way):
        found = super().callees(way)
        for f in found:
            if f not in self.frame and not LIBRARY.match(f):
                sys.exit(f"{way[-1]} calls {f}, whose stack nobody knows")
        return found

    def deepest(self, roots):
        return max((self.depth(f) for f in roots if f in self.frame), default=(0, 0, ()))


def measure(core, folder, elf):
    """(static bytes, bytes of stack, the way down)."""
    screen = os.path.basename(elf).removesuffix(".elf")
    symbols = {}
    for line in subprocess.check_output(["arm-none-eabi-nm", elf], text=True).splitlines():
        words = line.split()
        symbols[words[-1]] = int(words[0], 16)
    names = glob.glob(f"{core}/**/*.ci", recursive=True) + glob.glob(f"{folder}/board/**/*.ci", recursive=True)
    program = Program(sorted(names) + [f"{folder}/{screen}.ci"], screen, symbols)
    thread, interrupt = program.deepest(["reset"]), program.deepest(
        [f for f in program.frame if f.startswith("rp2040_") and f.endswith("_interrupt")])
    if not thread[2] or not interrupt[2]:
        sys.exit(f"{elf}: no reset or no interrupt in the call graphs")
    static = symbols["link_bss_end"] - symbols["link_data_start"]
    return static, thread[0] + interrupt[0] + EXCEPTION + LIBGCC, thread[2]


def main():
    limit, core, folder, *elves = sys.argv[1:]
    failed = 0
    print("| screen | static | stack | RAM in all, bytes | limit |\n|---|--:|--:|--:|--:|")
    for elf in elves:
        static, stack, way = measure(core, folder, elf)
        over = static + stack > int(limit)
        failed += over
        print(f"| {os.path.basename(elf)} | {static:,} | {stack:,} | {static + stack:,} | {int(limit):,}"
              f"{' **over**' if over else ''} |")
        print("    deepest: " + " > ".join(f.split(":")[-1] for f in way))
    print(f"{len(elves) - failed} passed, {failed} failed")
    sys.exit(failed != 0)


main()
