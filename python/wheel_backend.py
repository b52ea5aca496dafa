# SPDX-License-Identifier: Apache-2.0
"""What pip asks to make a wheel of the module [PEP 517, PEP 427]: CMake builds it, this file packs it.

`--config-settings build=FOLDER` names a build folder, an existing one included; else it is build/pip."""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def version():
    return re.search(r"project\(cdsm VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def build_module(folder):
    """The module for the Python that runs this, built in `folder`: where, and its files."""
    if not (folder / "CMakeCache.txt").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DCDSM_TESTS=OFF",
                        f"-DCDSM_PYTHON_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "cdsm_python", "--parallel", str(os.cpu_count())],
                   check=True)
    made = folder / "python"
    scripts = sorted([*made.glob("cdsm_*.py"), *made.glob("cdsm_vtk/*.py")])
    return made, [made / ("cdsm" + sysconfig.get_config_var("EXT_SUFFIX")), made / "cdsm.pyi", *scripts]


def tag():
    python = "cp%d%d" % sys.version_info[:2]
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = pathlib.Path((config_settings or {}).get("build", ROOT / "build/pip")).resolve()
    info = f"cdsm-{version()}.dist-info"
    made, files = build_module(folder)
    contents = {str(path.relative_to(made)): path.read_bytes() for path in files}
    contents[f"{info}/METADATA"] = (f"Metadata-Version: 2.1\nName: cdsm\nVersion: {version()}\nLicense: Apache-2.0\n"
                                    "Requires-Python: >=3.9\nRequires-Dist: numpy\n").encode()
    contents[f"{info}/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: cdsm\nRoot-Is-Purelib: false\n"
                                 f"Tag: {tag()}\n").encode()
    contents[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(record_line(name, content) for name, content in contents.items())
    contents[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    name = f"cdsm-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in contents.items():
            wheel.writestr(path, content)
    return name
