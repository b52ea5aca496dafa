#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Code in the documentation is code of the examples: check_snippets.py PAGE FOLDER_OF_EXAMPLES

Each block of C++, OpenCL C or Python on the page must be in one of the examples, line by line. Prints those that
are not; exit status 1 if there is one."""
import pathlib
import re
import sys

BLOCK = re.compile(r"^```(?:cpp|c|python)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def main():
    page = pathlib.Path(sys.argv[1])
    examples = [path.read_text() for path in sorted(pathlib.Path(sys.argv[2]).iterdir()) if path.is_file()]
    blocks = BLOCK.findall(page.read_text())
    missing = [block for block in blocks if not any("\n" + block in text for text in examples)]
    for block in missing:
        print(f"{page.name}: in no example:\n{block}")
    print(f"{len(blocks)} blocks of code, {len(missing)} of them in no example")
    sys.exit(1 if missing or not blocks else 0)


if __name__ == "__main__":
    main()
