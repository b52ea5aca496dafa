#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tests of the Python module, and the example: run_tests.py FOLDER_OF_THE_MODULE ROOT

Code on the page docs/python.md must be code of the example, line by line."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
TIMEOUT_SECONDS = 120


def missing_snippets(root, example):
    """Blocks of the page that are not in the example."""
    blocks = BLOCK.findall((root / "docs/python.md").read_text())
    return [block for block in blocks if "\n" + block not in example.read_text()] if blocks else ["no block of code"]


def run_example(example, module):
    """Whether it ends well and leaves a picture with more than one colour."""
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "fog.ppm"
        status = subprocess.run([sys.executable, "-B", example, picture], timeout=TIMEOUT_SECONDS,
                                env={**os.environ, "PYTHONPATH": module}).returncode
        return status == 0 and len(set(picture.read_bytes()[20:])) > 50


def main():
    module, root = sys.argv[1], pathlib.Path(sys.argv[2])
    sys.path[:0] = [module, str(root / "tests/python")]
    example = root / "examples/light_in_fog.py"
    for block in missing_snippets(root, example):
        sys.exit(f"docs/python.md: not in {example.name}:\n{block}")
    if not run_example(example, module):
        sys.exit(f"{example.name} failed")
    suite = unittest.defaultTestLoader.discover(str(root / "tests/python"))
    sys.exit(0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1)


if __name__ == "__main__":
    main()
