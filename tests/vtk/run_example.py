#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The example that draws a shadowed picture with VTK: run_example.py FOLDER_OF_THE_MODULES EXAMPLE.py

Skipped where this Python has no VTK, or where there is neither a display nor xvfb-run."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77  # the tests' SKIP_RETURN_CODE
TIMEOUT_SECONDS = 300
HEIGHT = 60

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(SKIPPED)


def screen():
    if os.environ.get("DISPLAY"):
        return []
    if not shutil.which("xvfb-run"):
        print("skipped: there is neither a display nor xvfb-run (package xvfb)")
        sys.exit(SKIPPED)
    return ["xvfb-run", "-a"]


def brightness(path):
    """Of the left and of the right half of a picture."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    picture = reader.GetOutput()
    width, height, _ = picture.GetDimensions()
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, -1)
    return [float(half.mean()) for half in (pixels[:, :width // 2], pixels[:, width // 2:])]


def main():
    module, example = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "torso.png"
        done = subprocess.run([*screen(), sys.executable, "-B", example, str(picture), str(HEIGHT)],
                              timeout=TIMEOUT_SECONDS, env={**os.environ, "PYTHONPATH": module})
        if done.returncode:
            sys.exit(f"{example}: exit status {done.returncode}")
        plain, shadowed = brightness(picture)
    print(f"brightness {plain:.1f} without shadows, {shadowed:.1f} with")
    sys.exit(0 if 20 < shadowed < 0.97 * plain else 1)


if __name__ == "__main__":
    main()
