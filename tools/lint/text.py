#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the sources as text: text.py, in the repository root.

The first line (the second, after #!) is the licence line; no to-do marks, no switched-off code, no line of more than
120 characters. Prints each problem; exit status 1 if there is one."""
import pathlib
import re
import sys

FOLDERS = ["host", "kernels", "python", "vtk", "tests", "examples", "scenes", "tools", ".ci"]
SUFFIXES = {".cpp", ".hpp", ".h", ".cl", ".clh", ".py", ".pyi", ".sh", ".cmake"}
NAMES = {"CMakeLists.txt", "run"}
WIDTH = 120  # characters, as in .clang-format, which lays out the C++ sources alone
LICENCE = "SPDX-License-Identifier: Apache-2.0"
LEFTOVERS = re.compile(r"\b(TO" r"DO|FIX" r"ME|X" r"XX|HA" r"CK)\b|^\s*#\s*if\s+0\b")


def sources():
    """All files that people write."""
    yield pathlib.Path("CMakeLists.txt")
    for folder in FOLDERS:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_file() and (path.suffix in SUFFIXES or path.name in NAMES):
                yield path


def problems(path):
    """What is wrong with one file, as (line, sentence)."""
    lines = path.read_text(encoding="utf-8").splitlines()
    first = 1 if lines and lines[0].startswith("#!") else 0
    if len(lines) <= first or LICENCE not in lines[first]:
        yield first + 1, f"this line must say {LICENCE}"
    for number, line in enumerate(lines, 1):
        if len(line) > WIDTH:
            yield number, f"{len(line)} characters, must be at most {WIDTH}"
        if LEFTOVERS.search(line):
            yield number, "leftover: " + line.strip()


def main():
    found = [f"{path}:{number}: {what}" for path in sources() for number, what in problems(path)]
    print("\n".join(found) or "licence lines are there, no leftovers, no long lines")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
