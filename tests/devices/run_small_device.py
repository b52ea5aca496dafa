#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A device of 1 GiB, 256 MiB at once: run_small_device.py CDSM DEVICE_TESTS SCENE

Through the library (tests SmallDevice) and through the tool: what does not fit is refused with the number of bytes that
it needs, with exit status 1 and nothing written; what fits still works."""
import pathlib
import re
import sys
import tempfile

import job

SMALL = {"POCL_MEMORY_LIMIT": "1", "CDSM_DEVICE": "Portable"}
TIMEOUT_SECONDS = 120
TOO_LARGE = [
    ["shadows.map_size=16384", "shadows.memory=atlas"],
    ["shadows.map_size=16384", "shadows.memory=chunked"],
    ["image.width=16384", "image.height=16384"],
]


def check_library(tests):
    status, output = job.run([tests, "--gtest_filter=SmallDevice.*"], TIMEOUT_SECONDS, **SMALL)
    if status != 0:
        job.fail(output[-8000:])
    if "[  SKIPPED ]" in output:
        job.skip("the device is not PoCL, which POCL_MEMORY_LIMIT makes small")


def render(cdsm, scene, image, settings):
    arguments = [part for setting in settings for part in ("--set", setting)]
    return job.run([cdsm, "render", scene, "-o", image, "--quiet"] + arguments, TIMEOUT_SECONDS, **SMALL)


def check_tool(cdsm, scene, folder):
    for settings in TOO_LARGE:
        status, output = render(cdsm, scene, folder / "large.png", settings)
        what = " ".join(settings) + f": exit status {status}, '{output.strip()}'"
        if status != 1 or output.count("\n") != 1 or not re.match(r"error: .*\d{7,}", output):
            job.fail("not refused in one line with the bytes needed: " + what)
        if list(folder.iterdir()):
            job.fail("left something behind: " + what)
        print("refused: " + output.strip())
    status, output = render(cdsm, scene, folder / "small.png", [])
    if status != 0 or not (folder / "small.png").exists():
        job.fail(f"a scene that fits does not render: exit status {status}, {output}")


def main():
    cdsm, tests, scene = sys.argv[1:]
    check_library(tests)
    with tempfile.TemporaryDirectory() as folder:
        check_tool(cdsm, scene, pathlib.Path(folder))


main()
