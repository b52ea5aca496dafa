#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes smoke.nrrd: a dense plume of layered value noise, uint8, N^3 voxels in the box [-0.5, 0.5]^3, y up.

usage: make_smoke.py [FILE] [N]    (default: smoke.nrrd beside this script, 256)

Deterministic; the Python standard library alone, a few seconds: noise and plume are evaluated on a coarse lattice of
N / 4 cells a side and enlarged separably, so that the inner loops are byte and list operations.
"""
import gzip
import math
import pathlib
import random
import sys

OCTAVES = ((4, 1.0), (8, 0.55), (16, 0.3), (32, 0.16))  # lattice cells per side, amplitude
DENSITY = 105.0  # value in the middle of the plume
SCALE = 4        # voxels per coarse cell
EDGE = 0.81      # where the plume ends, in its radii without turbulence: fills about two thirds of the box


def weights(size, cells):
    """For each of `size` places: lattice cell and smooth weight of the next one."""
    places = []
    for i in range(size):
        x = (i + 0.5) / size * cells
        f = x - int(x)
        places.append((int(x), f * f * (3.0 - 2.0 * f)))
    return places


def mix(a, b, t):
    return [p + t * (q - p) for p, q in zip(a, b)]


def noise(size, cells, rng):
    """size^3 values in [-1, 1], x fastest, as nested lists z, y, x."""
    lattice = [[[rng.uniform(-1, 1) for _ in range(cells + 1)] for _ in range(cells + 1)] for _ in range(cells + 1)]
    at = weights(size, cells)
    wide = [[[row[i] + t * (row[i + 1] - row[i]) for i, t in at] for row in plane] for plane in lattice]
    tall = [[mix(plane[i], plane[i + 1], t) for i, t in at] for plane in wide]
    return [[mix(a, b, t) for a, b in zip(tall[i], tall[i + 1])] for i, t in at]


def layered(size):
    rng = random.Random(1)
    layers = [(noise(size, cells, rng), amplitude) for cells, amplitude in OCTAVES if cells <= size // 2]
    return [[[sum(a * n[z][y][x] for n, a in layers) for x in range(size)] for y in range(size)] for z in range(size)]


def density(x, y, z, turbulence):
    """A plume that widens upwards and sways; x, y, z in [0, 1]."""
    radius = 0.33 + 0.36 * math.sqrt(y)
    dx = x - 0.5 - 0.05 * math.sin(5.0 * y)
    dz = z - 0.5 - 0.05 * math.cos(4.0 * y)
    away = math.hypot(dx, dz) / radius
    ends = min(1.0, 8.0 * y, 5.0 * (1.0 - y))
    inside = (1.0 - away / EDGE + 0.28 * turbulence) * ends
    return DENSITY * max(0.0, inside)


def coarse(size):
    fields = layered(size)
    at = [(i + 0.5) / size for i in range(size)]
    return [[[density(at[x], at[y], at[z], fields[z][y][x]) for x in range(size)] for y in range(size)]
            for z in range(size)]


def enlarge(size):
    """Voxel to the coarse cell below it and the linear weight of the next."""
    places = []
    for i in range(size * SCALE):
        x = min(max((i + 0.5) / SCALE - 0.5, 0.0), size - 1.000001)
        places.append((int(x), x - int(x)))
    return places


def voxels(size):
    cells, at = coarse(size), enlarge(size)
    wide = [[[row[i] + t * (row[i + 1] - row[i]) for i, t in at] for row in plane] for plane in cells]
    for k, t in at:
        plane = [mix(a, b, t) for a, b in zip(wide[k], wide[k + 1])]
        yield b"".join(bytes(map(int, mix(plane[j], plane[j + 1], s))) for j, s in at)


def header(n):
    s, o = 1.0 / n, 0.5 / n - 0.5
    return (f"NRRD0004\n# plume of layered noise\ntype: uint8\ndimension: 3\nspace dimension: 3\nsizes: {n} {n} {n}\n"
            f"space directions: ({s},0,0) (0,{s},0) (0,0,{s})\nspace origin: ({o},{o},{o})\n"
            "kinds: domain domain domain\nencoding: gzip\n\n").encode()


def main():
    target = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("smoke.nrrd"))
    n = int(sys.argv[2]) if len(sys.argv) > 2 else 256
    if n < 16 or n % SCALE:
        sys.exit(f"make_smoke.py: N is {n}; it must be a multiple of {SCALE}, at least 16")
    data = b"".join(voxels(n // SCALE))
    partial = target.with_name(target.name + ".part")
    partial.write_bytes(header(n) + gzip.compress(data, 1, mtime=0))
    partial.replace(target)
    filled = 100.0 * (1.0 - data.count(0) / len(data))
    print(f"{target}: {n}^3 voxels, {filled:.0f} % of them not 0, at most {max(data)}")


if __name__ == "__main__":
    main()
