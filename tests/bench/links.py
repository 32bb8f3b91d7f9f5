#!/usr/bin/env python3
"""links.py LINKS ELF ..: does each program link the stages it names, all of them and nothing else?
LINKS says how (size/links.txt). Every function of core in a program must belong to one of the
program's stages; every stage that a program names must be in it. Ends with status 1 if not."""
import os
import re
import subprocess
import sys

ARM = os.environ.get("ARM", "arm-none-eabi-")


def read(path):
    tables = {"stage": {}, "program": {}}
    for line in open(path):
        words = line.split("#")[0].split()
        if words:
            tables[words[0]].setdefault(words[1], []).extend(words[2:])
    return tables["stage"], tables["program"]


def functions(elf):
    names = subprocess.run([ARM + "nm", "--defined-only", elf], capture_output=True, text=True,
                           check=True).stdout.split("\n")
    return {n.split()[2][5:] for n in names if " etch_" in n}


def complaints(linked, wanted, stages):
    """What is wrong with a program that links these functions and names these stages."""
    used = {s for s in wanted for n in linked for p in stages[s] if re.fullmatch(p, n)}
    owned = {n for s in wanted for n in linked for p in stages[s] if re.fullmatch(p, n)}
    return [f"links etch_{n}, which it does not use" for n in sorted(linked - owned)] + \
           [f"links nothing of stage {s}" for s in sorted(set(wanted) - used)]


def main():
    stages, programs = read(sys.argv[1])
    failed = 0
    for elf in sys.argv[2:]:
        name = os.path.basename(elf)[:-4]
        wrong = complaints(functions(elf), programs[name], stages) if name in programs \
            else [f"is not in {sys.argv[1]}"]
        for text in wrong:
            print(f"FAIL {name}: {text}")
        failed += len(wrong) > 0
    print(f"{len(sys.argv) - 2 - failed} programs link what they draw with and nothing else")
    sys.exit(1 if failed else 0)


main()
