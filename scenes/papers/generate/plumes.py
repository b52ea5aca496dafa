# SPDX-License-Identifier: Apache-2.0
"""Smoke and steam: particles leave a source one after the other and are carried up by a draught and by turbulence, so
that what is seen at one moment are streaks, folded and torn. The density is what lies in each voxel at the end."""
from dataclasses import dataclass

import numpy as np

from . import turbulence

GRID = 96  # cells a side of the turbulence, which repeats


@dataclass(frozen=True)
class Plume:
    size: tuple        # voxels along x, y, z; y up
    height: float      # of the box; its middle stands on the source
    source: tuple      # radii of the source along x and z
    rise: float        # height gained per unit of time at the bottom
    wind: tuple        # drift along x and z per height gained at the top
    swirl: float       # speed of the turbulence where it is fully grown, in units of `rise`
    eddy: float        # size of the period of the turbulence
    spread: float      # how much wider streaks get by mixing, per square root of time
    seed: int
    puffs: float = 0.7  # how unevenly the source gives off smoke, over its face and over time
    particles: int = 1_500_000
    steps: int = 90


def sample(field, places, period):
    cells = np.floor(places * (GRID / period)).astype(np.int64) % GRID
    return field[cells[:, 2], cells[:, 1], cells[:, 0]]


def carried(plume, rng):
    """Where the particles are at the end, how much each of them weighs, and their ages in [0, 1]."""
    field = turbulence.flow(GRID, 2.0, 2.0, 24.0, rng)
    age = np.sort(rng.random(plume.particles))[::-1]
    turn, out = 2.0 * np.pi * rng.random(len(age)), np.sqrt(rng.random(len(age)))
    places = np.zeros((len(age), 3))
    places[:, 0] = plume.source[0] * out * np.cos(turn)
    places[:, 2] = plume.source[1] * out * np.sin(turn)
    lifetime = 1.25 * plume.height / plume.rise
    left = places + np.array([0.0, plume.rise * lifetime, 0.0]) * age[:, None]  # time as a third axis
    bursts = turbulence.scalar(GRID, 2.0, 2.0, 20.0, rng)
    weight = np.exp(plume.puffs * sample(bursts, left, plume.eddy))
    tick = lifetime / plume.steps
    for step in range(plume.steps):
        alive = np.searchsorted(-age, -(1.0 - (step + 0.5) / plume.steps))
        now = places[:alive]
        grown = np.clip(now[:, 1] / plume.height, 0.0, 1.0)
        drift = plume.rise * tick * step * 0.6  # the eddies rise too, slower than the smoke
        push = sample(field, now - [0.0, drift, 0.0], plume.eddy)
        strength = plume.swirl * plume.rise * np.minimum(1.0, 0.12 + 1.6 * grown)
        velocity = push * strength[:, None]
        velocity[:, 1] += plume.rise * (1.0 - 0.35 * grown)
        velocity[:, 0] += plume.wind[0] * plume.rise * grown
        velocity[:, 2] += plume.wind[1] * plume.rise * grown
        places[:alive] += tick * velocity
    jitter = plume.spread * np.sqrt(age * lifetime)
    return places + rng.standard_normal(places.shape) * jitter[:, None], weight, age


def splatted(places, weights, size, voxel):
    """Trilinear histogram [z, y, x] of points in voxel units, the box's first corner at 0."""
    width, height, depth = size
    at = places / voxel - 0.5
    cell = np.floor(at).astype(np.int64)
    inside = ((cell >= 0) & (cell < np.array(size) - 1)).all(1)
    at, cell, weights = at[inside], cell[inside], weights[inside]
    part = at - cell
    grid = np.zeros(width * height * depth)
    for corner in np.ndindex(2, 2, 2):
        share = np.prod(np.where(corner, part, 1.0 - part), 1) * weights
        x, y, z = (cell + corner).T
        grid += np.bincount((z * height + y) * width + x, share, len(grid))
    return grid.reshape(depth, height, width)


def blurred(grid):
    """Two passes of 1-2-1 along each axis."""
    for axis in (0, 1, 2, 0, 1, 2):
        edge = np.pad(grid, [(1, 1) if i == axis else (0, 0) for i in range(3)])
        low, mid, high = (np.take(edge, range(i, i + grid.shape[axis]), axis) for i in range(3))
        grid = 0.25 * low + 0.5 * mid + 0.25 * high
    return grid


def density(plume):
    """Voxels (0 to 255), their edge and the centre of the first one; the source lies at the origin."""
    rng = np.random.default_rng(plume.seed)
    voxel = plume.height / plume.size[1]
    corner = np.array([-0.5 * plume.size[0], 0.0, -0.5 * plume.size[2]]) * voxel
    places, weight, age = carried(plume, rng)
    weight *= np.clip((1.0 - age) / 0.45, 0.0, 1.0) ** 1.5
    grid = blurred(splatted(places - corner, weight, plume.size, voxel))
    width, height, depth = plume.size
    x, y, z = (np.abs(np.linspace(-1.0, 1.0, n)) for n in plume.size)
    wall = (np.clip((1.0 - x) / 0.15, 0, 1)[None, None, :] * np.clip((1.0 - z) / 0.15, 0, 1)[:, None, None])
    top = np.clip((1.0 - np.arange(height) / (height - 1.0)) / 0.3, 0.0, 1.0)
    grid = grid * wall * (top * top * (3.0 - 2.0 * top))[None, :, None]
    level = np.percentile(grid[grid > 0.02 * grid.max()], 97)
    voxels = np.round(255.0 * (1.0 - np.exp(-grid / level))).astype(np.uint8)
    voxels[[0, -1], :, :] = voxels[:, [0, -1], :] = voxels[:, :, [0, -1]] = 0
    return voxels, voxel, corner + 0.5 * voxel
