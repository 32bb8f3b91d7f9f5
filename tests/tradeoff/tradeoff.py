#!/usr/bin/env python3
"""tradeoff.py DIR BUILD: joins DIR/host/errors.csv with what the firmware counted and what programs weigh:
BUILD/tradeoff.csv, tradeoff.svg and tradeoff.md. Ends with status 1 if a firmware drew another picture
than the host, whose errors these are.

m0plus and m4 are instructions a pixel of the scene, flash is bytes at -Os on Cortex-M0+ of a program that
draws with the mode alone, ram the bytes of a 320 x 16 strip with all its planes, and of the triangles that
are kept for a frame."""
import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import chart
import choices

STRIP = 320 * 16


def read(directory):
    """A dict for every row of the table."""
    names = ("mode kernel scene unit mean p999 max program bytes triangle pixels triangles").split()
    rows = [dict(zip(names, r)) for r in csv.reader(open(f"{directory}/host/errors.csv"))]
    flash = {os.path.basename(line.split()[-1])[:-4]: int(line.split()[0]) + int(line.split()[1])
             for line in open(f"{directory}/flash.txt") if line.strip().endswith(".elf")}
    for core in ("m0plus", "m4"):
        counts = [int(line) for line in open(f"{directory}/{core}/counts")]
        if len(counts) != len(rows):
            sys.exit(f"tradeoff: {core} drew {len(counts)} pictures, not {len(rows)}")
        for row, count in zip(rows, counts):
            row[core + "_all"] = count
            row[core] = f"{count / int(row['pixels']):.3f}"
    for row in rows:
        row["flash"] = flash[row["program"]]
        row["ram"] = int(row["bytes"]) * STRIP + int(row["triangle"]) * int(row["triangles"])
    return rows


def check_pictures(directory):
    host = open(f"{directory}/host/hashes", "rb").read()
    for core in ("m0plus", "m4"):
        if open(f"{directory}/{core}/hashes", "rb").read() != host:
            sys.exit(f"tradeoff: pictures on {core} differ from the host's")


def main():
    directory, build = sys.argv[1:]
    check_pictures(directory)
    rows = read(directory)
    head = "mode,kernel,scene,unit,mean,p999,max,m0plus,m4,flash,ram".split(",")
    with open(f"{build}/tradeoff.csv", "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(head)
        out.writerows([row[h] for h in head] for row in rows)
    open(f"{build}/tradeoff.svg", "w").write(chart.svg(rows))
    apart = list(csv.reader(open(f"{directory}/host/separation.csv")))
    text = choices.tables(rows, apart)
    open(f"{build}/tradeoff.md", "w").write(text)
    print(text)


main()
