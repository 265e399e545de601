#!/usr/bin/env python3
"""Ids of GML files: none twice in one, no link to one that is not there.

    check_ids.py SOURCE|- FILE...

Links that dangle in SOURCE too are not held against the files.
"""
import re
import sys


def ids_and_links(name):
    with open(name, encoding="utf-8", errors="replace") as file:
        text = file.read()
    ids = re.findall(r'\bgml:id\s*=\s*"([^"]*)"', text)
    links = re.findall(r'(?:xlink:href|\buri|\bring)\s*=\s*"#([^"]*)"', text)
    links += re.findall(r'<app:(?:target|ring)>\s*#([^<]*?)\s*<', text)
    return ids, links


def is_sound(name, dangles):
    ids, links = ids_and_links(name)
    known, twice = set(), set()
    for i in ids:
        (twice if i in known else known).add(i)
    dangling = set(links) - known - dangles
    for what, found in (("twice", twice), ("dangling", dangling)):
        if found:
            print(f"{name}: {what}: {len(found)}: {sorted(found)[:5]}")
    return not twice and not dangling


def main():
    dangles = set()
    if sys.argv[1] != "-":
        ids, links = ids_and_links(sys.argv[1])
        dangles = set(links) - set(ids)
    sound = [is_sound(name, dangles) for name in sys.argv[2:]]
    sys.exit(0 if sound and all(sound) else 1)


if __name__ == "__main__":
    main()
