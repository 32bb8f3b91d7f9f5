#!/usr/bin/env python3
"""profile.py function|line|insn COUNTS [FUNCTION..]: where a workload's instructions go.

function: instructions, share, calls, instructions a call, per primitive and pixel, M0+ cycles.
line:     instructions per source line, inlined code at the line it comes from.
insn:     the functions that matter (or those named) disassembled, beside each instruction how
          often it ran, how often its branch was taken, its M0+ cycles and its source line.
On the host it is callgrind_annotate that shows them."""
import os
import re
import signal
import subprocess
import sys

ARM = os.environ.get("ARM", "arm-none-eabi-")


def run(*command, stdin=None):
    return subprocess.run(command, input=stdin, capture_output=True, text=True, check=True).stdout


def symbols(elf):
    """(address, name) of the functions, ascending."""
    rows = [line.split() for line in run(ARM + "nm", "-n", elf).splitlines()]
    return [(int(r[0], 16), r[2]) for r in rows if r[1] in "tTwW" and not r[2].startswith("$")]


def read_counts(path):
    counts = {}
    for line in open(path):
        address, *n = line.split()
        old = counts.get(int(address, 16), (0, 0, 0))
        counts[int(address, 16)] = tuple(a + int(b) for a, b in zip(old, n))
    return counts


def by_function(counts, table):
    """name -> [instructions, calls, cycles]; a call is a run of the first instruction."""
    out, i = {}, 0
    for address in sorted(counts):
        while i + 1 < len(table) and table[i + 1][0] <= address:
            i += 1
        f = out.setdefault(table[i][1], [0, 0, 0])
        f[0] += counts[address][0]
        f[2] += counts[address][2]
        if address == table[i][0]:
            f[1] = counts[address][0]
    return out


def print_functions(functions, truth, cycles):
    total = sum(f[0] for f in functions.values())
    px, prim = int(truth["pixels"]), int(truth["primitives"])
    print(f"{'function':36}{'instructions':>13}{'share':>8}{'calls':>10}{'a call':>10}"
          f"{'/prim':>10}{'/px':>9}{'M0+ cycles/px' if cycles else '':>15}")
    rows = sorted(functions.items(), key=lambda r: -r[1][0])
    rows.append(("total", [total, 0, sum(f[2] for f in functions.values())]))
    for name, (n, calls, cyc) in rows:
        print(f"{name:36}{n:13}{100 * n / total:7.2f}%{calls or '':>10}"
              f"{f'{n / calls:.1f}' if calls else '':>10}{n / prim:10.1f}{n / px:9.3f}"
              f"{f'{cyc / px:.3f}' if cycles else '':>15}")


def source_lines(elf, addresses):
    """address -> path:line of the innermost inlined function."""
    found = run(ARM + "addr2line", "-e", elf, stdin="\n".join(f"{a:x}" for a in addresses))
    return {a: re.sub(r"\s*\(discriminator.*", "", place)
            for a, place in zip(addresses, found.splitlines())}


def print_lines(elf, counts, truth):
    px, prim = int(truth["pixels"]), int(truth["primitives"])
    total = sum(c[0] for c in counts.values())
    by_line = {}
    for address, place in source_lines(elf, sorted(counts)).items():
        by_line[place] = by_line.get(place, 0) + counts[address][0]
    print(f"{'instructions':>13}{'share':>8}{'/prim':>10}{'/px':>9}")
    for place, n in sorted(by_line.items(), key=lambda r: -r[1]):
        path, _, number = place.rpartition(":")
        if n < total / 500:
            break
        text = ""
        if os.path.exists(path):
            text = open(path).read().splitlines()[int(number) - 1].strip()
        print(f"{n:13}{100 * n / total:7.2f}%{n / prim:10.1f}{n / px:9.3f}  "
              f"{os.path.basename(place):26} {text}")


def print_insns(elf, counts, functions, wanted):
    lines = {a: os.path.basename(p) for a, p in source_lines(elf, sorted(counts)).items()}
    total = sum(c[0] for c in counts.values())
    wanted = wanted or [f for f, n in functions.items() if n[0] >= total / 100]
    show = False
    for line in run(ARM + "objdump", "-d", "--no-show-raw-insn", elf).splitlines():
        head = re.match(r"[0-9a-f]+ <(.*)>:", line)
        insn = re.match(r"\s*([0-9a-f]+):\t(.*)", line)
        if head:
            name = head[1]
            show = name in wanted
            if show and name in functions:
                n = functions[name][0]
                print(f"\n{name}: {n} instructions, {100 * n / total:.2f} %")
                print(f"{'runs':>10}{'taken':>10}{'cycles':>10}")
        elif insn and show:
            address = int(insn[1], 16)
            n, taken, cycles = counts.get(address, (0, 0, 0))
            text = insn[2].replace("\t", " ").split(" @ ")[0]
            print(f"{n or '.':>10}{taken or '':>10}{cycles or '':>10}  {address:6x}  {text:42}"
                  f"{lines.get(address, '')}")


def main():
    kind, path, wanted = sys.argv[1], sys.argv[2], sys.argv[3:]
    place = os.path.dirname(path)
    bench, core, work = place.rsplit(os.sep, 2)
    if core.startswith("host"):
        print(run("callgrind_annotate", "--auto=" + ("no" if kind == "function" else "yes"),
                  f"{place}/callgrind.out"))
        return
    words = open(f"{bench}/host-portable/{work}/truth.txt").read().split()
    elf, counts = f"{place}.elf", read_counts(path)
    functions = by_function(counts, symbols(elf))
    print(f"{work.upper()} on {core}")
    truth = dict(zip(words[::2], words[1::2]))
    if kind == "function":
        print_functions(functions, truth, core.startswith("m0plus"))
    elif kind == "line":
        print_lines(elf, counts, truth)
    else:
        print_insns(elf, counts, functions, wanted)


signal.signal(signal.SIGPIPE, signal.SIG_DFL)
main()
