#!/usr/bin/env python3
"""size.py BUDGETS [--symbols] [--write FILE] [--enforce NAME..] -- ELF..: what programs weigh.

A program's flash is .text + .rodata + .data of its ELF, with all it pulls in. It is named after
the row of BUDGETS it belongs to, NAME for the fast code or NAME_small for the small. With
--enforce, the named ones over their budget end with status 1; the others are marked.
--write puts the table into FILE between the lines <!-- size --> and <!-- /size -->."""
import csv
import os
import subprocess
import sys

ARM = os.environ.get("ARM", "arm-none-eabi-")


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def flash(elf):
    sizes = {}
    for line in run(ARM + "size", "-A", elf).splitlines():
        words = line.split()
        if words and words[0] in (".text", ".rodata", ".data"):
            sizes[words[0]] = int(words[1])
    return sum(sizes.values())


def symbols(elf):
    """(size, name) of what lies in flash, largest first; ends with what no symbol claims."""
    rows = [line.split() for line in run(ARM + "nm", "-S", "--size-sort", "-r", elf).splitlines()]
    at = {r[0]: (int(r[1], 16), r[3]) for r in rows if r[2] in "tTwWrRdD"} # aliases once
    out = list(at.values())
    rest = flash(elf) - sum(s for s, _ in out)
    return out + ([(rest, "(libgcc and alignment)")] if rest else [])


def state(size, budget):
    if not budget:
        return ""
    return "ok" if size <= int(budget) else f"over by {size - int(budget)}"


def rows_of(budgets, elfs):
    for row in budgets:
        for kind, name in (("small", row["program"] + "_small"), ("fast", row["program"])):
            if name in elfs:
                # Until a small variant exists, the one there is stands for both.
                only = kind == "fast" and row["program"] + "_small" not in elfs
                budget = row["budget_small"] if kind == "small" or not row["budget_fast"] else row["budget_fast"]
                yield name, row["what"], kind if not only else "only", flash(elfs[name]), budget
                if only and row["budget_fast"]:
                    yield name, row["what"], "as small", flash(elfs[name]), row["budget_small"]


def main():
    options, elfs = sys.argv[1:sys.argv.index("--")], sys.argv[sys.argv.index("--") + 1:]
    enforce = options[options.index("--enforce") + 1].split() if "--enforce" in options else []
    elfs = {os.path.basename(e)[:-4]: e for e in elfs}
    budgets = list(csv.DictReader(open(options[0])))
    lines = ["| program | code | flash, bytes | budget | |", "|---|---|---|---|---|"]
    failed = False
    for name, what, kind, size, budget in rows_of(budgets, elfs):
        failed |= name in enforce and bool(budget) and size > int(budget)
        lines.append(f"| {what} | {kind} | {size} | {budget} | {state(size, budget)} |")
    print("\n".join(lines))
    for row in budgets:
        if row["program"] not in elfs and row["program"] + "_small" not in elfs:
            print(f"{row['what']}: no program yet")
    if "--symbols" in options:
        for name, elf in elfs.items():
            print(f"\n{name}: {flash(elf)} bytes")
            for size, symbol in symbols(elf):
                print(f"{size:7} {symbol}")
    if "--write" in options:
        path = options[options.index("--write") + 1]
        text = open(path).read()
        before, rest = text.split("<!-- size -->\n", 1)
        after = rest.split("<!-- /size -->", 1)[1]
        open(path, "w").write(before + "<!-- size -->\n" + "\n".join(lines) + "\n<!-- /size -->" + after)
    sys.exit(1 if failed else 0)


main()
