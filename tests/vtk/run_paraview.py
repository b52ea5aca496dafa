#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ParaView's plugin, its example, and the filters with ParaView's own VTK, in pvpython: run_paraview.py MODULES

MODULES is the folder that they are in.

Skipped where there is none with its module (Debian's python3-paraview), or it is of another Python than cdsm."""
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77  # the tests' SKIP_RETURN_CODE
TIMEOUT_SECONDS = 300
HERE = pathlib.Path(__file__).resolve().parent
EXAMPLE = HERE.parents[1] / "examples/vtk/paraview_wavelet.py"


def run(pvpython, module, *arguments):
    paths = [module] + [path for path in [os.environ.get("PYTHONPATH")] if path]
    return subprocess.run([pvpython, "-B", *map(str, arguments)], timeout=TIMEOUT_SECONDS,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)}).returncode


def main():
    module, pvpython = sys.argv[1], shutil.which("pvpython")
    if not pvpython or run(pvpython, module, "-c", "import paraview, cdsm"):
        print("skipped: there is no pvpython that has the modules paraview and cdsm")
        sys.exit(SKIPPED)
    for command in (HERE / "run_python.py", module), (HERE / "paraview_pipelines.py",), (EXAMPLE,):
        status = run(pvpython, module, *command)
        if status:
            sys.exit(f"{command[0].name}: exit status {status}")


if __name__ == "__main__":
    main()
