# SPDX-License-Identifier: Apache-2.0
"""Meshes made from scratch."""
import numpy as np

from . import meshes

BOX = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
SIDES = np.array([(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6),
                  (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)])


def box(low, high):
    low, high = np.asarray(low, float), np.asarray(high, float)
    return low + BOX * (high - low), SIDES


def closed_tube(curve, radius, around):
    """A tube along a closed curve (n, 3)."""
    n = len(curve)
    along = meshes.unit(np.roll(curve, -1, 0) - np.roll(curve, 1, 0))
    bend = meshes.unit(np.roll(along, -1, 0) - np.roll(along, 1, 0))
    side = np.cross(along, bend)
    turn = 2.0 * np.pi * np.arange(around) / around
    ring = np.cos(turn)[:, None, None] * bend + np.sin(turn)[:, None, None] * side
    points = (curve + radius * ring).transpose(1, 0, 2).reshape(-1, 3)
    i, j = (index.ravel() for index in np.meshgrid(np.arange(n), np.arange(around), indexing="ij"))
    a, b = i * around + j, i * around + (j + 1) % around
    c, d = (i + 1) % n * around + j, (i + 1) % n * around + (j + 1) % around
    return points, np.vstack([np.column_stack([a, b, d]), np.column_stack([a, d, c])])


def knot(p=2, q=3, steps=240, around=28):
    """A torus knot of radius 1.4 that stands on y = 0."""
    t = 2.0 * np.pi * np.arange(steps) / steps
    r = 1.0 + 0.4 * np.cos(q * t)
    curve = np.column_stack([r * np.cos(p * t), r * np.sin(p * t), 0.4 * np.sin(q * t)])
    points, triangles = closed_tube(curve, 0.19, around)
    return points - [0.0, points[:, 1].min(), 0.0], triangles


def pergola(width=3.0, height=2.5, depth=2.0, rafters=11):
    """Four posts, two beams, rafters across them and a trellis at the back; its middle stands on the origin."""
    parts = [box((x - 0.08, 0, z - 0.08), (x + 0.08, height, z + 0.08))
             for x in (-0.42 * width, 0.42 * width) for z in (-0.4 * depth, 0.4 * depth)]
    parts += [box((-0.5 * width, height, z - 0.06), (0.5 * width, height + 0.16, z + 0.06))
              for z in (-0.4 * depth, 0.4 * depth)]
    parts += [box((x - 0.03, height + 0.16, -0.58 * depth), (x + 0.03, height + 0.3, 0.58 * depth))
              for x in np.linspace(-0.47 * width, 0.47 * width, rafters)]
    parts += [box((x - 0.02, 0.3, -0.4 * depth - 0.02), (x + 0.02, height, -0.4 * depth + 0.02))
              for x in np.linspace(-0.34 * width, 0.34 * width, 7)]
    parts += [box((-0.42 * width, y - 0.02, -0.4 * depth - 0.02), (0.42 * width, y + 0.02, -0.4 * depth + 0.02))
              for y in np.linspace(0.3, height - 0.3, 6)]
    return meshes.merged(parts)


def frame(width, height, bar, depth):
    """Four bars around an opening of width x height; the middle of its back at the origin."""
    x, y = 0.5 * width, 0.5 * height
    return meshes.merged([box((-x - bar, -y - bar, 0), (x + bar, -y, depth)),
                          box((-x - bar, y, 0), (x + bar, y + bar, depth)),
                          box((-x - bar, -y, 0), (-x, y, depth)), box((x, -y, 0), (x + bar, y, depth))])


def stage(radius, half_width=30.0, depth=30.0, height=15.0, steps=24):
    """A floor y = 0 that runs through a cove into a wall z = 0: a strip of quads, seen from +z."""
    turn = np.linspace(0.0, 0.5 * np.pi, steps + 1)
    profile = np.vstack([[[depth, 0.0]], np.column_stack([radius * (1 - np.sin(turn)), radius * (1 - np.cos(turn))]),
                         [[0.0, height]]])
    points = np.array([(x, y, z) for z, y in profile for x in (-half_width, half_width)])
    low = 2 * np.arange(len(profile) - 1)
    return points, np.vstack([np.column_stack([low, low + 1, low + 3]), np.column_stack([low, low + 3, low + 2])])


def ball(rings=24, around=48):
    """A unit sphere."""
    tilt, turn = np.pi * np.arange(1, rings) / rings, 2.0 * np.pi * np.arange(around) / around
    points = np.stack([np.outer(np.sin(tilt), np.cos(turn)), np.outer(np.cos(tilt), np.ones(around)),
                       np.outer(np.sin(tilt), np.sin(turn))], -1).reshape(-1, 3)
    points = np.vstack([points, [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]])
    i, j = (index.ravel() for index in np.meshgrid(np.arange(rings - 2), np.arange(around), indexing="ij"))
    a, b, c, d = (row * around + column % around for row in (i, i + 1) for column in (j, j + 1))
    first, following = np.arange(around), (np.arange(around) + 1) % around
    low = (rings - 2) * around
    top, bottom = np.full(around, len(points) - 2), np.full(around, len(points) - 1)
    return points, np.vstack([np.column_stack([a, b, d]), np.column_stack([a, d, c]),
                              np.column_stack([top, following, first]),
                              np.column_stack([bottom, low + first, low + following])])
