# SPDX-License-Identifier: Apache-2.0
"""A walnut as a CT scanner would see it: wrinkled shell with a seam, papery septum, two folded halves, air."""
import numpy as np

from generate import turbulence

SIZE = (152, 168, 192)         # voxels along z, y, x; the nut lies along x, its seam in the plane y = 0
FILL = 0.9                     # of the box, along each axis
SEPTUM, SHELL, KERNEL = 60.0, 105.0, 190.0
NOISE = 2.5                    # deviation of the scanner's noise
EDGE = 0.03                    # width of borders, in half axes of the nut: two to three voxels


def soft(inside):
    """0 .. 1 across a border, of a distance that is positive inside."""
    return np.clip(inside / EDGE + 0.5, 0.0, 1.0)


def folds(lowest, highest, rng, stretched=False):
    """0 along winding lines, up to 1 between them. `stretched`: twice as long along x."""
    n = max(SIZE)
    field = turbulence.scalar(n, 1.0, lowest, highest, rng)
    if stretched:
        field = np.repeat(field, 2, axis=2)
        field = 0.5 * (field + np.roll(field, 1, axis=2))
    return np.clip(np.abs(field[:SIZE[0], :SIZE[1], :SIZE[2]]), 0.0, 1.0)


def density(seed):
    """Voxels of SIZE, 8 bits: 0 for air, then septum, shell and kernel, with borders about a voxel wide and noise."""
    rng = np.random.default_rng(seed)
    z, y, x = np.meshgrid(*((2.0 * (np.arange(s) + 0.5) / s - 1.0) / FILL for s in SIZE), indexing="ij")
    radius = np.sqrt(x * x + y * y + z * z)
    furrows, pores, brain = folds(6, 14, rng, True), folds(10, 24, rng), folds(4, 8, rng)
    tip = 0.05 * np.exp(-((1.0 - x) / 0.2) ** 2)          # where the nut is pointed
    seam = 0.05 * np.exp(-(y / 0.05) ** 2)
    outside = 0.87 + 0.1 * np.sqrt(furrows) + tip + seam  # radius of the shell's surface
    inside = 0.82 + 0.02 * brain
    shell = soft(outside - radius) * soft(radius - inside) * (0.85 + 0.15 * pores)
    wave = 0.03 * np.sin(7.0 * x) * np.cos(5.0 * z)
    septum = soft(0.014 - np.abs(y - wave)) * soft(inside - radius)
    # the halves touch the shell nowhere, are cleft along their middle, and hollow towards the septum
    cleft = 0.16 * np.exp(-(z / 0.09) ** 2)
    depth = 0.76 - radius - 0.17 * (1.0 - np.sqrt(brain)) - cleft
    gap = np.abs(y - wave) - 0.07 - 0.16 * np.exp(-(x * x + z * z) / 0.1)
    kernel = soft(np.minimum(depth, gap))
    voxels = np.maximum.reduce([SHELL * shell, SEPTUM * septum, KERNEL * kernel])
    return np.clip(np.round(voxels + NOISE * rng.standard_normal(SIZE)), 0, 255).astype(np.uint8)
