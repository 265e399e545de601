#!/usr/bin/env python3
"""Ids of a GML file: none twice, no link to one that is not there.

    check_ids.py FILE [SOURCE]

Links that dangle in SOURCE too are not held against FILE.
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


def main():
    ids, links = ids_and_links(sys.argv[1])
    known, twice = set(), set()
    for i in ids:
        (twice if i in known else known).add(i)
    dangling = set(links) - known
    if len(sys.argv) > 2:
        source_ids, source_links = ids_and_links(sys.argv[2])
        dangling -= set(source_links) - set(source_ids)
    for what, found in (("twice", twice), ("dangling", dangling)):
        if found:
            print(f"{what}: {len(found)}: {sorted(found)[:5]}")
    sys.exit(1 if twice or dangling else 0)


if __name__ == "__main__":
    main()
