#!/usr/bin/env python3
"""Write a STEP file of IFC again and again as one of about that many
megabytes: replicate_step.py FILE MEGABYTES [--one]. Each copy has instance
numbers and GlobalIds of its own; all of them stand in the project of the first,
and with --one in its building as well."""

import hashlib
import re
import sys

DIGITS = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"
GLOBAL_ID = re.compile(rb"'[0-3][0-9A-Za-z_$]{21}'")
TOKENS = re.compile(rb"('(?:[^']|'')*'|#\d+)")


def global_id(old, copy):
    number = int.from_bytes(
        hashlib.md5(old + b"%d" % copy).digest(), "big")
    digits = bytes(DIGITS[number >> shift & 63] for shift in range(0, 126, 6))
    return b"'%d%s'" % (number >> 126, digits)


def main():
    with open(sys.argv[1], "rb") as file:
        text = file.read()
    size = float(sys.argv[2]) * 1e6
    first = re.search(rb"\bDATA\s*;\s*", text).end()
    last = text.rindex(b"ENDSEC")
    kinds = b"PROJECT|SITE|BUILDING" if "--one" in sys.argv else b"PROJECT"
    once = re.compile(
        rb"#(\d+)\s*=\s*IFC(?:" + kinds + rb")\s*\(.*?;\s*?\n", re.S)
    write = sys.stdout.buffer.write
    written = write(text[:last])
    shared = {int(one[1]) for one in once.finditer(text)}
    pieces = TOKENS.split(once.sub(b"", text[first:last]))
    numbers = {i: int(pieces[i][1:]) for i in range(1, len(pieces), 2)
               if pieces[i][:1] == b"#"}
    names = [i for i in range(1, len(pieces), 2)
             if GLOBAL_ID.fullmatch(pieces[i])]
    step = max(numbers.values()) + 1
    copy = 1
    while written < size:
        for i, number in numbers.items():
            if number not in shared:
                pieces[i] = b"#%d" % (number + copy * step)
        fresh = list(pieces)
        for i in names:
            fresh[i] = global_id(pieces[i], copy)
        written += write(b"".join(fresh))
        copy += 1
    write(text[last:])


main()
