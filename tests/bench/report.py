#!/usr/bin/env python3
"""report.py BENCH_DIR COUNTS..: the table of `make bench`, and build/bench.csv.

Each COUNTS is BENCH_DIR/CORE-VARIANT/wN/counts.txt; BENCH_DIR/host-portable/wN/truth.txt holds
what the checked picture consists of. The clears before a picture are never counted.
Rows of core rp2040 are cycles of the Cortex-M0+ model stated in plugin.c, not instructions."""
import csv
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
NAMES = {"m0plus": "Cortex-M0+, instructions", "m4": "Cortex-M4, instructions",
         "host": "this machine, instructions (callgrind)"}


def read_counts(path):
    """Instructions and M0+ cycles in all."""
    rows = [line.split() for line in open(path)]
    if len(rows[0]) == 1:
        return int(rows[0][0]), None
    return sum(int(r[1]) for r in rows), sum(int(r[3]) for r in rows)


def read_truth(bench, n):
    words = open(f"{bench}/host-portable/w{n}/truth.txt").read().split()
    return {k: int(v) for k, v in zip(words[::2], words[1::2])}


def units_of(n, truth):
    """What a total is divided by, the unit of the comparison first."""
    px, prim, frames = truth["pixels"], truth["primitives"], truth.get("frames", 1)
    if n == 15:
        return {"frame": frames, "prim": prim}
    if n in (10, 11, 13):
        return {"tested_px": px, "prim": prim}
    if n in (3, 6, 8):
        return {"prim": prim, "px": px}
    return {"px": px, "prim": prim}


def number(v):
    return f"{v:.0f}" if v >= 1000 else f"{v:.1f}" if v >= 100 else f"{v:.3f}" if v < 10 else f"{v:.2f}"


def table_line(peer, value, second, cycles, variant):
    best, goal = peer["peer_best"], peer[f"target_{variant}"]
    ratio = f"{float(best) / value:.2f}x" if best else ""
    state = "" if not goal else "ok" if value <= float(goal) else f"over by {100 * (value / float(goal) - 1):.0f} %"
    print(f"{peer['workload']:4} {peer['name']:27} {number(value):>9} /{peer['unit']:10}"
          f"{second:>20} {cycles:>10} {best:>9} {ratio:>8} {goal:>9}  {state}")


def main():
    bench, paths = sys.argv[1], sys.argv[2:]
    peers = {(p["workload"], p["core"]): p for p in csv.DictReader(open(f"{HERE}/peers.csv"))}
    out = []
    previous = None
    for path in paths:
        place, work = path.split(os.sep)[-3:-1]
        core, variant = place.split("-")
        n = int(work[1:])
        truth = read_truth(bench, n)
        total, cycles = read_counts(path)
        units = units_of(n, truth)
        peer = peers[f"W{n}", core]
        if place != previous:
            print(f"\n{NAMES[core]}, {variant} code\n"
                  f"{'':33}{'value':>9} {'':11}{'also':>20} {'M0+ cycles':>10} {'peer':>9} {'cheaper':>8} {'target':>9}")
            previous = place
        for unit, divisor in units.items():
            known = peer["peer_best"] if unit == peer["unit"] else ""
            out.append((f"W{n}", core, variant, unit, f"{total / divisor:.4f}", known))
        if core == "m0plus":
            for unit, divisor in units.items():
                out.append((f"W{n}", "rp2040", variant, f"cycles/{unit}", f"{cycles / divisor:.4f}", ""))
        first, second = list(units.items())
        table_line(peer, total / first[1], f"{number(total / second[1])} /{second[0]}",
                   number(cycles / first[1]) if core == "m0plus" else "", variant)
    with open(f"{os.path.dirname(bench)}/bench.csv", "w", newline="") as f:
        w = csv.writer(f, lineterminator="\n")
        w.writerow(("workload", "core", "variant", "unit", "value", "peer_best"))
        w.writerows(out)


main()
