#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the meshes and volumes of the scenes beside it in the folder generated/: about a minute, always the same bytes.

usage: make_data.py [NAME...]    (without names: all that is missing or older than the scripts)
"""
import pathlib
import sys

sys.dont_write_bytecode = True
try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit("make_data.py: needs NumPy (Debian: apt-get install python3-numpy)")

from generate import meshes, plumes, shapes, volumes

HERE = pathlib.Path(__file__).resolve().parent
TARGET = HERE / "generated"


def mesh_file(name, crease):
    return lambda path: meshes.save_smooth(path, *meshes.read_ply(HERE / "data" / name), crease)


def shape(make):
    return lambda path: meshes.save_smooth(path, *make())


def plume(**settings):
    def write(path):
        voxels, edge, origin = plumes.density(plumes.Plume(**settings))
        volumes.write_nrrd(path, voxels, (edge, edge, edge), origin, "particles carried by turbulence")
    return write


RECIPES = {
    "car.ply": mesh_file("sports_car.ply.gz", 35.0),
    "bunny.ply": mesh_file("stanford_bunny.ply.gz", 60.0),
    "dragon.ply": mesh_file("stanford_dragon_res3.ply.gz", 60.0),
    "knot.ply": shape(shapes.knot),
    "pergola.ply": shape(shapes.pergola),
    "smoke.nrrd": plume(size=(112, 176, 112), height=2.2, source=(0.22, 0.3), rise=1.0, wind=(0.12, -0.1), swirl=0.55,
                        eddy=1.6, spread=0.02, seed=3),
    "steam.nrrd": plume(size=(80, 144, 80), height=1.8, source=(0.33, 0.33), rise=1.0, wind=(0.05, 0.03), swirl=0.42,
                        eddy=1.3, spread=0.012, seed=5),
}


def main():
    names = sys.argv[1:]
    unknown = [name for name in names if name not in RECIPES]
    if unknown:
        sys.exit(f"make_data.py: no recipe for '{unknown[0]}'; there are {', '.join(RECIPES)}")
    TARGET.mkdir(exist_ok=True)
    newest = max(path.stat().st_mtime for path in [HERE / "make_data.py", *HERE.glob("generate/*.py")])
    for name, write in RECIPES.items():
        path = TARGET / name
        if name in names or not names and not (path.exists() and path.stat().st_mtime >= newest):
            partial = path.with_name("part." + name)
            write(partial)
            partial.replace(path)
            print(f"{path}: {path.stat().st_size} bytes", flush=True)


if __name__ == "__main__":
    main()
