#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tiny scenes under the interpreter oclgrind: run_oclgrind.py DEVICE_TESTS KERNELS WORK_FOLDER [--planted]

Looks for accesses out of bounds, data races and misused API calls in every kernel. With --planted, faults are written
into copies of the kernels, and each must be found: a check that finds nothing has to be seen finding something.
--uninitialized is left out: oclgrind 21.10 stops at LLVM's freeze instruction and, without optimization, crashes; the
test Uninitialized of device_tests looks for the same by other means."""
import argparse
import pathlib
import re
import shutil
import tempfile

import job

TIMEOUT_SECONDS = 240
FORCED_INLINE = "static inline __attribute__((always_inline))"

# file, what stands there (a pattern), what is planted instead, what oclgrind says to it, test that runs it
FAULTS = [
    ("render/shade.cl", r"image\[(.+?)\] = ", r"image[(\1) + params.view.width] = ", "Invalid write",
     "volumesWithoutShadows"),
    ("build/rasterize.cl", r"atomic_inc\(&tilePairs\[tile\]\);", r"++tilePairs[tile];", "race",
     "volumesWithoutShadows"),
    ("build/scan.cl", r"sums\[count\] = sum", r"sums[count + 1] = sum", "Invalid write", "volumesWithoutShadows"),
    ("memory/tile_writer.clh", r"(reserveTile\(tile, shared, CDSM_MEMORY_WRITE_ARGS\);\n)  barrier\(.+\);", r"\1",
     "race", "volumesInExactMaps"),
]


def copy_kernels(kernels, folder):
    """A copy that oclgrind can run: it lacks the LLVM intrinsics that forced inlining leaves behind."""
    shutil.copytree(kernels, folder)
    for path in folder.rglob("*"):
        if path.is_file():
            path.write_text(path.read_text().replace(FORCED_INLINE, "static"))


def plant(folder, fault):
    path = folder / fault[0]
    text, count = re.subn(fault[1], fault[2], path.read_text())
    if count == 0:
        job.fail(f"the fault for {fault[0]} cannot be planted: '{fault[1]}' is no longer there, choose another place")
    path.write_text(text)


def findings(tests, kernels, work, tests_filter):
    """What oclgrind logged; the tests themselves must pass, else what they printed. Its own exit status is always 0."""
    log = work / "oclgrind.log"
    status, output = job.run(
        ["oclgrind", "--build-options", "-cl-opt-disable", "--data-races", "--check-api", "--log", log, tests,
         "--gtest_filter=" + tests_filter], TIMEOUT_SECONDS, CDSM_KERNELS=str(kernels),
        CDSM_CACHE_DIR=str(work / "cache"), CDSM_DEVICE="oclgrind")
    found = log.read_text() if log.exists() else ""
    if status is None:
        job.fail(f"no end after {TIMEOUT_SECONDS} s:\n{output}")
    if "[  PASSED  ]" not in output and not found:
        job.fail("the tests did not run to their end:\n" + output)
    return found if found or (status == 0 and "[  FAILED  ]" not in output) else output


def check(tests, kernels, work):
    copy_kernels(kernels, work / "kernels")
    found = findings(tests, work / "kernels", work, "*TinyEngine*")
    if found:
        job.fail("oclgrind reports:\n" + found[:8000])
    print("oclgrind reports nothing")


def check_planted(tests, kernels, work):
    for number, fault in enumerate(FAULTS):
        folder = work / f"fault{number}"
        folder.mkdir()
        copy_kernels(kernels, folder / "kernels")
        plant(folder / "kernels", fault)
        found = findings(tests, folder / "kernels", folder, f"*TinyEngine.{fault[4]}/buffer")
        if fault[3] not in found:
            job.fail(f"'{fault[2]}' in {fault[0]} was not found; oclgrind reports:\n" + found[:4000])
        print(f"found: {fault[2]} in {fault[0]}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tests", type=pathlib.Path)
    parser.add_argument("kernels", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--planted", action="store_true")
    options = parser.parse_args()
    if not shutil.which("oclgrind"):
        job.skip("oclgrind is not installed")
    options.work.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=options.work, prefix="oclgrind") as folder:
        (check_planted if options.planted else check)(options.tests, options.kernels, pathlib.Path(folder))


main()
