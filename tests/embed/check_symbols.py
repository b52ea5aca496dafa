#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a shared library shows: check_symbols.py LIBRARY FOLDER_OF_PUBLIC_HEADERS

Every symbol that it defines for others must be of a function or class that a header marks CDSM_API, and each of those
must be there. Prints what is not so; exit status 1 if anything is."""
import pathlib
import re
import subprocess
import sys

MARKED = re.compile(r"^(?:class\s+CDSM_API\s+(\w+)|CDSM_API\s+[^;(]*?(\w+)\()", re.MULTILINE)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.MULTILINE)
OF_CLASS = re.compile(r"^(?:vtable for |typeinfo for |typeinfo name for )?(cdsm(?:::\w+)*)")


def documented(folder):
    """Full names of all that the headers mark."""
    names = set()
    for header in sorted(folder.glob("*.hpp")):
        text = header.read_text()
        space = NAMESPACE.search(text)
        names |= {f"{space.group(1)}::{a or b}" for a, b in MARKED.findall(text)} if space else set()
    return names


def exported(library):
    """Names of what the library defines for others, demangled."""
    said = subprocess.run(["nm", "-D", "--defined-only", "--demangle", library],
                          capture_output=True, text=True, check=True)
    symbols = [line.split(" ", 2)[2] for line in said.stdout.splitlines()]
    return [symbol for symbol in symbols if "openvdb::" not in symbol]  # as tools/cmake/exports.map says


def main():
    names = documented(pathlib.Path(sys.argv[2]))
    problems, seen = [], set()
    for symbol in exported(sys.argv[1]):
        match = OF_CLASS.match(symbol)
        owners = {name for name in names if match and (match.group(1) + "::").startswith(name + "::")}
        seen |= owners
        if not owners:
            problems.append(f"shown, but not marked CDSM_API: {symbol}")
    problems += [f"marked CDSM_API, but not shown: {name}" for name in sorted(names - seen)]
    print("\n".join(problems) or f"{len(names)} functions and classes are shown, nothing else")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
