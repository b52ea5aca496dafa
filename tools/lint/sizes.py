#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the sizes of files and functions in lines, median and 90th percentile: sizes.py, in the repository root.

Functions are found by counting braces: good enough for numbers, no parser. Judges nothing; exit status 0."""
import pathlib
import re

PARTS = {
    "host": ["host/**/*.cpp", "host/**/*.hpp"],
    "kernels": ["kernels/**/*.cl", "kernels/**/*.clh", "kernels/**/*.h"],
    "python": ["python/*.cpp", "python/*.hpp"],
    "vtk": ["vtk/**/*.cpp", "vtk/**/*.hpp", "vtk/**/*.h"],
    "tests": ["tests/**/*.cpp", "tests/**/*.hpp"],
}
# Comments, strings, characters and preprocessor lines (continued ones whole), any of which may hold braces.
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|'
                   r"^[ \t]*#(?:\\\n|[^\n])*", re.DOTALL | re.MULTILINE)
SCOPE = re.compile(r"\b(namespace|class|struct|union|enum|extern)\b[^()]*$")


def without_noise(text):
    """The text with everything that may confuse a brace counter taken out; lines keep their numbers."""
    return NOISE.sub(lambda match: "\n" * match.group().count("\n"), text)


def function_lengths(text):
    """Lines of each function, from the first line of its head to its closing brace."""
    text = without_noise(text)
    lengths, scopes, head = [], [], 0  # scopes: per open brace, None or where a function's head starts
    for match in re.finditer(r"[{};]", text):
        before, mark = text[head:match.start()], match.group()
        if mark == "{":
            is_scope = bool(SCOPE.search(before)) or not before.strip()
            in_function = any(start is not None for start in scopes)
            starts = not in_function and not is_scope and ")" in before
            scopes.append(match.start() - len(before.lstrip()) if starts else None)
        elif mark == "}" and scopes:
            start = scopes.pop()
            if start is not None:
                lengths.append(text.count("\n", start, match.start()) + 1)
        head = match.end()
    return lengths


def summary(values):
    """Number, median, 90th percentile and greatest of some sizes."""
    values = sorted(values) or [0]
    return f"{len(values):5} {values[len(values) // 2]:7} {values[int(0.9 * (len(values) - 1))]:7} {values[-1]:7}"


def main():
    print(f"{'lines of':18}{'number':>6} {'median':>7} {'90 %':>7} {'most':>7}")
    for part, patterns in PARTS.items():
        texts = [path.read_text() for pattern in patterns for path in sorted(pathlib.Path(".").glob(pattern))]
        lengths = [length for text in texts for length in function_lengths(text)]
        print(f"{part + ' files':18} {summary(text.count(chr(10)) for text in texts)}")
        print(f"{part + ' functions':18} {summary(lengths)}")


if __name__ == "__main__":
    main()
