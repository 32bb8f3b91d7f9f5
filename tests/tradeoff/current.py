#!/usr/bin/env python3
"""current.py SOURCE BUILD: whether the committed table, chart and README.md are what was measured just now.
Prints the rows that differ, and "N passed, N failed", a row each."""
import sys


def main():
    source, build = sys.argv[1:]
    old = open(f"{source}/tradeoff.csv").read().split("\n")
    new = open(f"{build}/tradeoff.csv").read().split("\n")
    failed = 0
    for i in range(max(len(old), len(new))):
        a, b = (t[i] if i < len(t) else "" for t in (old, new))
        if a != b:
            failed += 1
            print(f"FAIL committed {a}\n     measured  {b}")
    checks = {"chart": open(f"{source}/tradeoff.svg").read() == open(f"{build}/tradeoff.svg").read(),
              "README.md": open(f"{build}/tradeoff.md").read() in open(f"{source}/README.md").read()}
    for name, ok in checks.items():
        if not ok:
            failed += 1
            print(f"FAIL {name} is not today's: make tradeoff-write")
    print(f"{len(new) + len(checks) - failed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


main()
