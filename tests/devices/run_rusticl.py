#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A second OpenCL implementation, which prefers images: run_rusticl.py CDSM KERNEL_TESTS PROPERTY_TESTS

Kernel tests and closed forms by rusticl on llvmpipe (Mesa). Few programs, since rusticl takes half a minute and more to
compile one that shades with maps."""
import json
import sys

import job

VARIABLES = {"RUSTICL_ENABLE": "llvmpipe", "CDSM_DEVICE": "rusticl"}
TIMEOUT_SECONDS = 600
CLOSED_FORMS = "All/ClosedForms.hold/SlabMapchunkedbilinearimage:All/ClosedForms.hold/SlabRaysimage"
KERNELS = "Rasterize.*:*ScanSizes*:*Math*:*Types/VolumeSamples.areTrilinear/*:*Int16image"


def has_rusticl(cdsm):
    status, output = job.run([cdsm, "devices", "--json"], 60, **VARIABLES)
    start = output.find("[")
    if status != 0 or start < 0:
        return False
    return any("rusticl" in device.get("platform", "").lower() for device in json.loads(output[start:]))


def check(binary, tests_filter):
    status, output = job.run([binary, "--gtest_filter=" + tests_filter], TIMEOUT_SECONDS, **VARIABLES)
    if status is None:
        job.fail(f"{binary}: no end after {TIMEOUT_SECONDS} s\n{output[-4000:]}")
    if status != 0 or "[  PASSED  ] 0 tests" in output:
        job.fail(f"{binary}:\n{output[-3000:]}")
    print(output[output.rfind("[==========]"):])


def main():
    cdsm, kernel_tests, property_tests = sys.argv[1:]
    if not has_rusticl(cdsm):
        job.skip("there is no rusticl device (package mesa-opencl-icd)")
    check(kernel_tests, KERNELS)
    check(property_tests, CLOSED_FORMS)


main()
