#!/usr/bin/env python3
"""insert.py DOCUMENT NAME TEXT: puts the file TEXT into DOCUMENT between the lines
<!-- NAME --> and <!-- /NAME -->; an error if they are not there."""
import sys

document, name, text = sys.argv[1:]
begin, end = f"<!-- {name} -->\n", f"<!-- /{name} -->\n"
whole = open(document).read()
if begin not in whole or end not in whole:
    sys.exit(f"{document}: no lines {begin.strip()} and {end.strip()}")
before, after = whole.split(begin)[0], whole.split(end)[1]
open(document, "w").write(before + begin + open(text).read() + end + after)
