#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the includes of host/ point one way (docs/architecture.md): includes.py, in the repository root.

Each folder may include itself, the public headers, shared structs and the folders listed for it, nothing else of the
project. Only device/ and the public opencl.hpp include OpenCL. Prints each wrong include; exit status 1 if there
is one."""
import pathlib
import re
import sys

# From what a user calls down to the device; a folder may include all that stand behind it.
LAYERS = ["cli", "engine", "render", "technique", "build", "memory", "device"]
# Beside the layers: values and functions without a device, and files.
VALUES = {"scene": set(), "cluster": {"scene"}, "io": {"scene"}}
ALWAYS = {"cdsm", "shared"}
PROJECT = set(LAYERS) | set(VALUES) | ALWAYS
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([A-Za-z0-9_]+)/[^">]*[">]')


def allowed_of(folder):
    """Folders that files of this one may include."""
    if folder in VALUES:
        return VALUES[folder] | ALWAYS | {folder}
    below = set(LAYERS[LAYERS.index(folder):]) | ALWAYS
    if folder != "device":
        below |= {"scene", "cluster"}
    return below | {"io"} if folder == "cli" else below


def problem(folder, target):
    """What is wrong with an include of `target`/... in a file of `folder`, or None."""
    if target == "CL" and folder != "device":
        return "only device/ includes OpenCL"
    if target in PROJECT and target not in allowed_of(folder):
        return f"{folder}/ must not know {target}/"
    return None


def folders(root):
    """(name, path) of each folder with rules."""
    yield "cli", root / "host/cli"
    for path in sorted((root / "host/src").iterdir()):
        yield path.name, path


def main():
    found = []
    for folder, path in folders(pathlib.Path(".")):
        if folder not in LAYERS and folder not in VALUES:
            found.append(f"{path}: no rule says what this folder may include")
            continue
        for file in sorted(path.rglob("*.[ch]pp")):
            for number, line in enumerate(file.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                wrong = problem(folder, match.group(1)) if match else None
                if wrong:
                    found.append(f"{file}:{number}: {wrong}")
    for file in sorted(pathlib.Path("host/include").rglob("*.hpp")):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            allowed = {"cdsm", "glm", "CL"} if file.name == "opencl.hpp" else {"cdsm", "glm"}
            if match and match.group(1) not in allowed:
                found.append(f"{file}:{number}: public headers include cdsm/, glm/ and the standard library alone")
    print("\n".join(found) or "includes point one way")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
