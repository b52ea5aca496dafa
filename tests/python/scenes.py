# SPDX-License-Identifier: Apache-2.0
"""What the tests look at."""
import math

import numpy as np

import cdsm

SIZE = 16
DENSITY = 1.5  # 1 / world length, of slab()


def voxels(value=1.0):
    return np.full((SIZE, SIZE, SIZE), value, np.float32)


def slab(data, **more):
    """A volume around the origin, 2 long on each side, whose extinction is the voxels' value times DENSITY."""
    scale = 2.0 / SIZE
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = -1.0 + 0.5 * scale
    # an opacity of 1 - exp(-d) over a length of 1 is an extinction of d
    opacity = [(v, 1.0 - math.exp(-DENSITY * v)) for v in np.linspace(0.0, 1.0, 101)]
    return cdsm.Volume(name="slab", voxels=data, object_from_index=matrix,
                       transfer=cdsm.TransferFunction(opacity=opacity, color=[(0, 1, 1, 1)]), **more)


def scene(data=None, **shadows):
    """The slab under a light that shines down."""
    return cdsm.Scene(camera=cdsm.Camera(position=(0, 0.5, 5)), image=cdsm.ImageSettings(width=36, height=24),
                      shadows=cdsm.ShadowSettings(**{"map_size": 64, "tolerance": 0.001, **shadows}),
                      lights=[cdsm.Light(name="sun", type="directional", direction=(0, -1, 0))],
                      volumes=[slab(voxels() if data is None else data)])


def points(count=64):
    """Down the middle of the slab, from above it to below."""
    result = np.zeros((count, 3), np.float32)
    result[:, 1] = np.linspace(1.5, -1.5, count)
    return result


def expected(where, value=1.0):
    """The transmittance by formula: exp(-density * length) [Beer and Lambert]."""
    return np.exp(-DENSITY * value * np.clip(1.0 - where[:, 1], 0.0, 2.0))
