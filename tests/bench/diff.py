#!/usr/bin/env python3
"""diff.py BASELINE NEW: what got better or worse; status 1 if a figure is more than 2 % worse.

Figures that differ by less than 0.05 % are not mentioned; a figure of the baseline that NEW
lacks is an error, unless its workload was not run at all."""
import csv
import sys


def read(path):
    return {tuple(r[k] for k in ("workload", "core", "variant", "unit")): float(r["value"])
            for r in csv.DictReader(open(path))}


def main():
    old, new = read(sys.argv[1]), read(sys.argv[2])
    worse = missing = 0
    for key, before in old.items():
        if key not in new:
            ran = any(k[:3] == key[:3] for k in new)
            missing += ran
            if ran:
                print(f"{' '.join(key)}: missing")
            continue
        change = 100 * (new[key] / before - 1) if before else 0
        if abs(change) >= 0.05:
            word = "better" if change < 0 else "WORSE" if change > 2 else "worse"
            print(f"{key[0]:4} {key[1]:7} {key[2]:9} {key[3]:18} {before:14.3f} -> "
                  f"{new[key]:14.3f} {change:+7.2f} %  {word}")
        worse += change > 2
    for key in new.keys() - old.keys():
        print(f"{' '.join(key)}: new, {new[key]:.3f}")
    print(f"{len(old.keys() & new.keys())} figures compared, {worse} more than 2 % worse")
    sys.exit(1 if worse or missing else 0)


main()
