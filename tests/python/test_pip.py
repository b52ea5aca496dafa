# SPDX-License-Identifier: Apache-2.0
"""`pip install .`, without the net, of the module as it is built already."""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cdsm

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT_SECONDS = 300


@unittest.skipUnless(importlib.util.find_spec("pip"), "pip is not installed")
class Pip(unittest.TestCase):
    def run_python(self, *arguments, **more):
        done = subprocess.run([sys.executable, "-B", *arguments], timeout=TIMEOUT_SECONDS, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_pip_installs_the_module(self):
        build = pathlib.Path(cdsm.__file__).parent.parent
        with tempfile.TemporaryDirectory() as folder:
            self.run_python("-m", "pip", "install", "--no-index", "--no-deps", "--target", folder, "--config-settings",
                            f"build={build}", ROOT)
            said = self.run_python("-c", "import cdsm; print(cdsm.__file__, cdsm.__version__, cdsm.Scene())",
                                   cwd=folder, env={"PYTHONPATH": folder})
            self.assertTrue(said.startswith(folder), said)
            self.assertIn(cdsm.__version__, said)
            for file in "cdsm.pyi", "cdsm_vtk/filters.py", "cdsm_paraview.py":
                self.assertTrue((pathlib.Path(folder) / file).exists(), file)
            listed = self.run_python("-m", "pip", "list", "--path", folder)
            self.assertRegex(listed, r"cdsm +" + cdsm.__version__)


if __name__ == "__main__":
    unittest.main()
