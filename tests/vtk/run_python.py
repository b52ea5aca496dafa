#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The filters of the module cdsm_vtk with the VTK that this Python has: run_python.py FOLDER_OF_THE_MODULES

Skipped where it has none; Debian's python3-vtk9 and pvpython have one."""
import pathlib
import sys
import unittest

SKIPPED = 77  # the tests' SKIP_RETURN_CODE
HERE = pathlib.Path(__file__).resolve().parent

sys.path[:0] = [sys.argv[1], str(HERE / "python")]
try:
    import vtkmodules.vtkCommonCore as core
    import cdsm
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(SKIPPED)
print("VTK", core.vtkVersion.GetVTKVersion(), "and", cdsm.__file__)
outcome = unittest.TextTestRunner(verbosity=2).run(
    unittest.defaultTestLoader.discover(str(HERE / "python")))
sys.exit(0 if outcome.wasSuccessful() else 1)
