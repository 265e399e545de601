#!/usr/bin/env python3
"""Write a CityGML file again and again as one of about that many megabytes:
replicate.py FILE MEGABYTES. The ids, and the links to them, get the number of
their copy; the head and what stands behind the last member come once."""

import re
import sys

NAMES = re.compile(
    rb"""((?:\bid|\bring)=["']|=["']#|>\s*#)([^"'<\s]+)"""
)


def main():
    with open(sys.argv[1], "rb") as file:
        text = file.read()
    size = float(sys.argv[2]) * 1e6
    first = re.search(rb"<[\w:]*cityObjectMember\b", text).start()
    last = text.rindex(b"cityObjectMember>") + len(b"cityObjectMember>")
    pieces = NAMES.split(text[first:last])
    write = sys.stdout.buffer.write
    written = write(text[:first])
    copy = 0
    while written < size:
        # split gives text, opening, name, text, opening, name, ..., text
        mark = b"_%d" % copy
        pieces_now = list(pieces)
        pieces_now[2::3] = [name + mark for name in pieces[2::3]]
        written += write(b"".join(pieces_now))
        copy += 1
    write(text[last:])


main()
