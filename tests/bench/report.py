#!/usr/bin/env python3
"""report.py BENCH_DIR COUNTS..: the table of `make bench`, also in bench.md and bench.csv beside
BENCH_DIR.

Each COUNTS is BENCH_DIR/CORE-VARIANT/wN/counts.txt; BENCH_DIR/host-portable/wN/truth.txt holds
what the checked picture consists of. The clears before a picture are never counted.
CSV rows of core rp2040 are cycles of the Cortex-M0+ model in plugin.c, not instructions."""
import csv
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
CORES = {"m0plus": "Cortex-M0+: instructions, and RP2040 cycles by the model in plugin.c",
         "m4": "Cortex-M4: instructions", "host": "This machine: instructions (callgrind)"}
HEAD = ("", "workload", "value", "per", "also", "RP2040 cycles", "peers' best", "cheaper",
        "target", "")


def read_counts(path):
    """Instructions, and M0+ cycles or None."""
    rows = [line.split() for line in open(path)]
    if len(rows[0]) == 1:
        return int(rows[0][0]), None
    return sum(int(r[1]) for r in rows), sum(int(r[3]) for r in rows)


def read_truth(bench, n):
    words = open(f"{bench}/host-portable/w{n}/truth.txt").read().split()
    return {k: int(v) for k, v in zip(words[::2], words[1::2])}


def units_of(n, truth):
    """What a total is divided by, the unit of the comparison first."""
    px, prim = truth["pixels"], truth["primitives"]
    if n == 15:
        return {"frame": truth["frames"], "prim": prim}
    if n in (10, 11, 13):
        return {"tested_px": px, "prim": prim}
    if n in (3, 6, 8, 14):
        return {"prim": prim, "px": px}
    return {"px": px, "prim": prim}


def number(v):
    return f"{v:,.0f}" if v >= 1000 else f"{v:.3g}" if v >= 100 else f"{v:.2f}"


def verdict(value, goal):
    if not goal:
        return ""
    over = 100 * (value / float(goal) - 1)
    return "ok" if over <= 0 else f"{over:.0f} % over"


def row_of(peer, total, cycles, units, variant):
    (unit, divisor), (second, other) = units.items()
    value, best, goal = total / divisor, peer["peer_best"], peer[f"target_{variant}"]
    return (peer["workload"], peer["name"], number(value), unit,
            f"{number(total / other)} /{second}", number(cycles / divisor) if cycles else "",
            number(float(best)) if best else "", f"{float(best) / value:.2f}x" if best else "",
            number(float(goal)) if goal else "", verdict(value, goal))


def aligned(rows):
    """A Markdown table whose columns also line up on a terminal."""
    widths = [max(len(r[i]) for r in rows) for i in range(len(rows[0]))]
    cells = [[c.ljust(w) if i in (0, 1, 3, 9) else c.rjust(w)
              for i, (c, w) in enumerate(zip(r, widths))] for r in rows]
    rule = ["-" * w if i in (0, 1, 3, 9) else "-" * (w - 1) + ":" for i, w in enumerate(widths)]
    return "\n".join("| " + " | ".join(r) + " |" for r in [cells[0], rule] + cells[1:])


def main():
    bench, paths = sys.argv[1], sys.argv[2:]
    peers = {(p["workload"], p["core"]): p for p in csv.DictReader(open(f"{HERE}/peers.csv"))}
    figures, tables = [], {}
    for path in paths:
        place, work = path.split(os.sep)[-3:-1]
        core, variant = place.split("-")
        n = int(work[1:])
        total, cycles = read_counts(path)
        units, peer = units_of(n, read_truth(bench, n)), peers[f"W{n}", core]
        cycles = cycles if core == "m0plus" else None
        for unit, divisor in units.items():
            best = peer["peer_best"] if unit == peer["unit"] else ""
            figures.append((f"W{n}", core, variant, unit, f"{total / divisor:.4f}", best))
            if cycles:
                figures.append((f"W{n}", "rp2040", variant, f"cycles/{unit}",
                                f"{cycles / divisor:.4f}", ""))
        tables.setdefault(place, [HEAD]).append(row_of(peer, total, cycles, units, variant))
    text = "\n".join(f"{CORES[p.split('-')[0]]}; {p.split('-')[1]} code\n\n{aligned(t)}\n"
                     for p, t in tables.items())
    print(text, end="")
    open(f"{os.path.dirname(bench)}/bench.md", "w").write(text)
    with open(f"{os.path.dirname(bench)}/bench.csv", "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(("workload", "core", "variant", "unit", "value", "peer_best"))
        out.writerows(figures)


main()
