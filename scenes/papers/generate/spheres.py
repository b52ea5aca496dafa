# SPDX-License-Identifier: Apache-2.0
"""Translucent balls, each with a value of its own, in one volume."""
import numpy as np

STEP = 36  # between the values of two balls
# Middle (x, y, z) and radius in parts of the box, large ones in front of and beneath small ones.
BALLS = (((0.32, 0.70, 0.55), 0.20), ((0.70, 0.74, 0.40), 0.16), ((0.56, 0.42, 0.66), 0.17),
         ((0.24, 0.30, 0.36), 0.15), ((0.78, 0.30, 0.50), 0.18), ((0.50, 0.16, 0.30), 0.12))


def balls(side):
    """side^3 voxels: 0 outside, STEP, 2 STEP ... inside of the balls, with borders a voxel wide."""
    axis = (np.arange(side) + 0.5) / side
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    voxels = np.zeros((side, side, side))
    for number, (middle, radius) in enumerate(BALLS, 1):
        away = np.sqrt((x - middle[0]) ** 2 + (y - middle[1]) ** 2 + (z - middle[2]) ** 2)
        voxels += number * STEP * np.clip((radius - away) * side + 0.5, 0.0, 1.0)
    return np.round(voxels).astype(np.uint8)
