#!/usr/bin/env python3
"""until.py COMMAND ..: runs a firmware of unit tests, prints what it says and stops it after the line
"N passed, N failed", since a board goes on when its program has ended. Fails if that line does not
come within LIMIT_S, or counts a failure."""
import re
import subprocess
import sys

LIMIT_S = 240


def main():
    board = subprocess.Popen(["timeout", str(LIMIT_S)] + sys.argv[1:], stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    for line in board.stdout:
        text = line.decode("latin1").rstrip()
        print(text, flush=True)
        if m := re.fullmatch(r"(\d+) passed, (\d+) failed", text):
            board.terminate()
            sys.exit(0 if m[1] != "0" and m[2] == "0" else 1)
    sys.exit("it ended without a result")


main()
