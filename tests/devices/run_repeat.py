#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Same input, same device, same build: the same bytes. run_repeat.py CDSM SCENE_FOLDER

Two scenes, each by two processes and once more on one core: PNG, EXR and transmittances of all memory
strategies, of shadow rays, of shadow maps and of stochastic ones; and spheres by maps of them."""
import pathlib
import random
import sys
import tempfile

import job

TIMEOUT_SECONDS = 120
SETTINGS = [["shadows.memory=" + name] for name in ["chunked", "atlas", "exact", "tiled", "fixed"]]
SETTINGS += [["shadows.node_format=unorm16", "shadows.memory=exact"]]
SETTINGS += [["shadows.technique=" + name] for name in ["shadow-rays", "shadow-map", "stochastic"]]
SETTINGS += [["shadows.technique=deep-shadow-map", "shadows.cache=volume"]]
SPHERES = """
[camera]
position = [0.0, 3.0, 9.0]
[shadows]
technique = "implicit-sphere"
map_size = 128
[[light]]
name = "key"
position = [3.0, 9.0, 4.0]
[[material]]
name = "atoms"
[[spheres]]
name = "cloud"
file = "cloud.xyz"
material = "atoms"
"""
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


def check_spheres(cdsm):
    draw = random.Random(1)
    places = [[f"{draw.uniform(-2.0, 2.0):.4f}" for axis in "xyz"] for _ in range(400)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "spheres.toml").write_text(SPHERES)
        (folder / "cloud.xyz").write_text("200\n\n" + "".join(f"C {' '.join(place)}\n" for place in places[:200]))
        (folder / "points.csv").write_text("x,y,z\n" + "".join(f"{','.join(place)}\n" for place in places[200:]))
        for settings in [["shadows.patch=1"], ["shadows.patch=auto", "shadows.softness=0.5"]]:
            check(cdsm, folder / "spheres.toml", settings)


def main():
    cdsm, folder = sys.argv[1:]
    check_spheres(cdsm)
    for name in ["sheets.toml", "overlapping_slabs.toml"]:
        for settings in SETTINGS:
            check(cdsm, pathlib.Path(folder) / name, settings)


main()
