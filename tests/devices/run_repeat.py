#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Same input, same device, same build: the same bytes. run_repeat.py CDSM SCENE_FOLDER

Two scenes, each by two processes and once more on one core: PNG, EXR and transmittances of all memory
strategies, of shadow rays, of shadow maps and of stochastic ones."""
import pathlib
import sys
import tempfile

import job

TIMEOUT_SECONDS = 120
SETTINGS = [["shadows.memory=" + name] for name in ["chunked", "atlas", "exact", "tiled", "fixed"]]
SETTINGS += [["shadows.node_format=unorm16", "shadows.memory=exact"]]
SETTINGS += [["shadows.technique=" + name] for name in ["shadow-rays", "shadow-map", "stochastic"]]
SETTINGS += [["shadows.technique=deep-shadow-map", "shadows.cache=volume"]]
IMAGE = ["image.width=90", "image.height=60"]
RUNS = [{"POCL_MAX_PTHREAD_COUNT": "2"}, {"POCL_MAX_PTHREAD_COUNT": "2"}, {"POCL_MAX_PTHREAD_COUNT": "1"}]


def outputs(cdsm, scene, settings, variables, folder):
    """The bytes of all results of one scene, by file name."""
    arguments = [part for setting in settings + IMAGE for part in ("--set", setting)]
    points = scene.parent / "points.csv"
    commands = [["render", scene, "-o", folder / "image.png"], ["render", scene, "-o", folder / "image.exr"],
                ["transmittance", scene, "--light", "key", "--points", points, "-o", folder / "points.csv"]]
    for command in commands:
        status, output = job.run([cdsm] + command + ["--quiet"] + arguments, TIMEOUT_SECONDS, **variables)
        if status != 0:
            job.fail(f"{scene.name} {settings}: exit status {status}: {output}")
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def check(cdsm, scene, settings):
    results = []
    for variables in RUNS:
        with tempfile.TemporaryDirectory() as folder:
            results.append(outputs(cdsm, scene, settings, variables, pathlib.Path(folder)))
    for result, variables in zip(results[1:], RUNS[1:]):
        differing = [name for name in results[0] if result.get(name) != results[0][name]]
        if differing:
            job.fail(f"{scene.name} {settings}: {', '.join(differing)} differ in a second run with {variables}")
    print(f"{scene.name} {settings}: the same bytes")


def main():
    cdsm, folder = sys.argv[1:]
    for name in ["sheets.toml", "overlapping_slabs.toml"]:
        for settings in SETTINGS:
            check(cdsm, pathlib.Path(folder) / name, settings)


main()
