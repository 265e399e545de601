#!/usr/bin/env python3
"""Checks of C and C++ sources that no compiler makes.

lint_sources.py includes FILE...   who may include whom
lint_sources.py sizes FILE...      lines of a function and of a file

Prints what is wrong, a line each, and exits 1 when anything is.
"""

import re
import sys
from pathlib import Path

MAX_FUNCTION = 100
MAX_FILE = 700
STAGES = ("parsers", "simplify", "writers")

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def includes(path):
    """Folders of the tree that a file's includes lead to."""
    for name in INCLUDE.findall(path.read_text()):
        beside = path.parent / name
        if beside.exists():
            yield name, Path(*beside.resolve().relative_to(Path.cwd()).parts)
        elif (Path("lib") / name).exists():
            yield name, Path("lib") / name


def wrong_includes(path):
    own = path.parts[0]
    if own not in STAGES and own != "lib" and len(path.parts) > 1:
        return  # tests and samples may look everywhere
    for name, target in includes(path):
        folder = target.parts[0] if len(target.parts) > 1 else "."
        if folder not in ("lib", own if len(path.parts) > 1 else "."):
            yield f'{path}: includes "{name}" of {folder}/'


def wrong_sizes(path):
    lines = path.read_text().splitlines()
    if len(lines) > MAX_FILE:
        yield f"{path}: {len(lines)} lines, more than {MAX_FILE}"
    start = None
    for number, line in enumerate(lines, 1):
        if line == "{":
            start = number
        elif line.startswith("}") and start:
            length = number - start + 1
            if length > MAX_FUNCTION:
                yield f"{path}:{start}: a function of {length} lines"
            start = None


def main():
    check = {"includes": wrong_includes, "sizes": wrong_sizes}[sys.argv[1]]
    wrong = [text for name in sys.argv[2:] for text in check(Path(name))]
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
