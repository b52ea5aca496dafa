#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the meshes, volumes and molecules of the scenes beside it in the folder generated/, in about half a minute and
the same from run to run.

usage: make_data.py [NAME...]    (without names: all that is missing or older than the scripts)
"""
import functools
import pathlib
import sys

sys.dont_write_bytecode = True
try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit("make_data.py: needs NumPy (Debian: apt-get install python3-numpy)")

from generate import car, fog, meshes, particles, plumes, shapes, spheres, volumes, walnut

HERE = pathlib.Path(__file__).resolve().parent
TARGET = HERE / "generated"
SCAN = HERE.parent / "demo/data/torso_ct_512x512x96_u8.nrrd"


def scanned(name, crease):
    return lambda path: meshes.save_smooth(path, *meshes.read_ply(HERE / "data" / name), crease)


def shape(make, *arguments):
    return lambda path: meshes.save_smooth(path, *make(*arguments))


@functools.lru_cache(maxsize=1)
def car_parts():
    return car.parts(HERE / "data/sports_car.ply.gz")


def car_part(name):
    return lambda path: meshes.save_smooth(path, *car_parts()[name], 35.0)


def plume(**settings):
    def write(path):
        voxels, edge, origin = plumes.density(plumes.Plume(**settings))
        volumes.write_nrrd(path, voxels, (edge, edge, edge), origin, "particles carried by turbulence")
    return write


def ball_volume(path):
    """Two units wide, its bottom on y = 0.02."""
    edge = 2.0 / 128
    volumes.write_nrrd(path, spheres.balls(128), (edge, edge, edge),
                       (0.5 * edge - 1, 0.5 * edge + 0.02, 0.5 * edge - 1), "translucent balls")


def nut(path):
    """Two units long, lying on y = 0."""
    edge = 2.0 / (walnut.FILL * walnut.SIZE[2])
    low = [-0.5 * edge * (walnut.SIZE[2] - 1), 0.5 * edge, -0.5 * edge * (walnut.SIZE[0] - 1)]
    volumes.write_nrrd(path, walnut.density(seed=7), (edge, edge, edge), low, "a made-up walnut")


def fog_bank(path):
    """12 m x 2.8 m x 12 m, its bottom on y = 0."""
    voxels = fog.density(120, 28, 120, seed=11)
    volumes.write_nrrd(path, voxels, (0.1, 0.1, 0.1), (-5.95, 0.05, -5.95), "ground fog")


def coarser(factor):
    """The CT with voxels `factor` (2, 4, ...) times as long."""
    def write(path):
        voxels, spacing = volumes.read_nrrd(SCAN)
        for _ in range(factor.bit_length() - 1):
            voxels = volumes.halved(voxels)
        volumes.write_nrrd(path, voxels, [factor * s for s in spacing], [0.5 * (factor - 1) * s for s in spacing],
                           "chest CT of ../../demo/data, means of its voxels")
    return write


def million(path):
    particles.save_xyz(path, "a ball of silver with grains of gold, an octant cut away", *particles.crystal_ball())


def virus(path):
    particles.save_xyz(path, "1IHM, Norwalk virus capsid: 60 copies of its unit",
                       *particles.capsid(HERE / "data/1ihm.pdb.gz"))


RECIPES = {
    "car.ply": scanned("sports_car.ply.gz", 35.0),
    **{f"car_{name}.ply": car_part(name) for name in ("paint", "paint_open", "glass", "tyres", "rims", "trim")},
    "bunny.ply": scanned("stanford_bunny.ply.gz", 60.0),
    "dragon.ply": scanned("stanford_dragon_res3.ply.gz", 60.0),
    "knot.ply": shape(shapes.knot),
    "pergola.ply": shape(shapes.pergola),
    "ball.ply": shape(shapes.ball),
    "box.ply": shape(shapes.box, (-0.5, 0.0, -0.5), (0.5, 1.0, 0.5)),
    "frame.ply": shape(shapes.frame, 780.0, 270.0, 14.0, 16.0),
    "stage.ply": shape(shapes.stage, 0.5),
    "smoke.nrrd": plume(size=(112, 176, 112), height=2.2, source=(0.2, 0.28), rise=1.0, wind=(0.12, -0.1), swirl=0.5,
                        eddy=1.6, spread=0.014, puffs=0.6, seed=3),
    "steam.nrrd": plume(size=(88, 152, 88), height=1.9, source=(0.27, 0.27), rise=1.0, wind=(0.05, 0.03), swirl=0.42,
                        eddy=1.1, spread=0.011, puffs=1.1, seed=5),
    "wisp.nrrd": plume(size=(72, 144, 72), height=1.6, source=(0.075, 0.075), rise=1.0, wind=(0.1, 0.03), swirl=0.36,
                       eddy=0.9, spread=0.018, puffs=0.8, seed=8),
    "fog.nrrd": fog_bank,
    "balls.nrrd": ball_volume,
    "walnut.nrrd": nut,
    "million.xyz.gz": million,
    "capsid.xyz.gz": virus,
    "torso_256.nrrd": coarser(2),
    "torso_128.nrrd": coarser(4),
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
