#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ParaView's plugin, and the filters with ParaView's own VTK, in pvpython: run_paraview.py FOLDER_OF_THE_MODULES

Skipped where there is no pvpython (Debian's python3-paraview), or one of another Python than the modules'."""
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77  # the tests' SKIP_RETURN_CODE
TIMEOUT_SECONDS = 300
HERE = pathlib.Path(__file__).resolve().parent


def run(pvpython, module, *arguments):
    paths = [module] + [path for path in [os.environ.get("PYTHONPATH")] if path]
    return subprocess.run([pvpython, "-B", *map(str, arguments)], timeout=TIMEOUT_SECONDS,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)}).returncode


def main():
    module, pvpython = sys.argv[1], shutil.which("pvpython")
    if not pvpython:
        print("skipped: there is no pvpython")
        sys.exit(SKIPPED)
    for script in HERE / "run_python.py", HERE / "paraview_pipelines.py":
        status = run(pvpython, module, script, module)
        if status:
            print(f"{script.name}: exit status {status}")
            sys.exit(SKIPPED if status == SKIPPED else 1)


if __name__ == "__main__":
    main()
