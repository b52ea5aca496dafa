# SPDX-License-Identifier: Apache-2.0
"""Ground fog: thick at the floor, thinner upwards, in wide soft banks."""
import numpy as np

from . import turbulence


def ramp(x):
    x = np.clip(x, 0.0, 1.0)
    return x * x * (3.0 - 2.0 * x)


def density(width, height, depth, seed):
    """Voxels [z, y, x]; the sides fade out."""
    rng = np.random.default_rng(seed)
    n = max(width, height, depth)
    noise = turbulence.scalar(n, 2.4, 1.5, 20.0, rng)[:depth, :2 * height:2, :width]
    up = (np.arange(height) + 0.5) / height
    fog = ramp((0.7 + 0.11 * noise - up[None, :, None]) / 0.55) * np.clip(0.75 + 0.1 * noise, 0.0, 1.0)
    x, z = (ramp((1.0 - np.abs(np.linspace(-1.0, 1.0, size))) / 0.4) for size in (width, depth))
    return np.round(255.0 * fog * x[None, None, :] * z[:, None, None]).astype(np.uint8)
