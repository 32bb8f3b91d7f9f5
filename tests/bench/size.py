#!/usr/bin/env python3
"""size.py BUDGETS [--symbols] [--enforce "NAME .."] -- ELF..: what programs weigh; the table is
also in size.md beside the directory of the ELFs.

A program's flash is .text + .rodata + .data of its ELF, with all it pulls in. It is named after
the row of BUDGETS it belongs to, NAME for the fast code or NAME_small for the small; until a
small one exists, the one there is stands for both. With --enforce, a named program over its
budget ends with status 1; the others are marked."""
import csv
import os
import subprocess
import sys

ARM = os.environ.get("ARM", "arm-none-eabi-")


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def flash(elf):
    lines = [line.split() for line in run(ARM + "size", "-A", elf).splitlines()]
    return sum(int(w[1]) for w in lines if w and w[0] in (".text", ".rodata", ".data"))


def symbols(elf):
    """(size, name) of what lies in flash, largest first; ends with what no symbol claims."""
    rows = [line.split() for line in run(ARM + "nm", "-S", "--size-sort", "-r", elf).splitlines()]
    by_address = {r[0]: (int(r[1], 16), r[3]) for r in rows if r[2] in "tTwWrRdD"}
    out = list(by_address.values())
    return out + [(flash(elf) - sum(s for s, _ in out), "(no symbol: libgcc, alignment)")]


def rows_of(budgets, elfs):
    """(program, what it draws, which code, bytes, budget or None)."""
    for row in budgets:
        for kind in ("small", "fast"):
            small, budget = row["program"] + "_small", row[f"budget_{kind}"]
            name = small if kind == "small" and small in elfs else row["program"]
            if budget and name in elfs:
                yield name, row["what"], kind, flash(elfs[name]), int(budget)
            elif budget:
                yield name, row["what"], kind, None, int(budget)


def state(size, budget):
    return "no program yet" if size is None else \
        "ok" if size <= budget else f"{size - budget} over"


def main():
    split = sys.argv.index("--")
    options = sys.argv[2:split]
    elfs = {os.path.basename(e)[:-4]: e for e in sys.argv[split + 1:]}
    enforce = options[options.index("--enforce") + 1].split() if "--enforce" in options else []
    text = "| program | code | flash, bytes | budget | |\n|---|---|---:|---:|---|\n"
    failed = False
    for name, what, kind, size, budget in rows_of(csv.DictReader(open(sys.argv[1])), elfs):
        failed |= name in enforce and (size is None or size > budget)
        text += f"| {what} | {kind} | {size or ''} | {budget} | {state(size, budget)} |\n"
    print(text, end="")
    if "--symbols" in options:
        for name, elf in elfs.items():
            print(f"\n{name}: {flash(elf)} bytes")
            for size, symbol in symbols(elf):
                print(f"{size:7} {symbol}")
    open(os.path.join(os.path.dirname(os.path.dirname(sys.argv[-1])), "..", "size.md"),
         "w").write(text)
    sys.exit(1 if failed else 0)


main()
