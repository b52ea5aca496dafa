#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Light in a ball of fog, from NumPy arrays: light_in_fog.py [PICTURE.ppm]

Exit status 0 if all of it is as it should be. PYTHONPATH names the folder of the module cdsm."""
import sys

import numpy as np

import cdsm


def ball(radius):
    """Density of a ball on 32^3 voxels, in [0, 1]."""
    z, y, x = (np.mgrid[0:32, 0:32, 0:32] - 15.5) / 16
    return np.clip(1 - np.sqrt(x * x + y * y + z * z) / radius, 0, 1).astype(np.float32)


def make_scene(voxels):
    fog = cdsm.Volume(name="fog", voxels=voxels)  # (z, y, x), stays ours: read in place
    fog.object_from_index = np.array([[0.06, 0, 0, -0.93], [0, 0.06, 0, -0.93], [0, 0, 0.06, -0.93], [0, 0, 0, 1]])
    fog.transfer = cdsm.TransferFunction(opacity=[(0, 0), (1, 0.8)], color=[(0, 1.0, 0.9, 0.8)], unit_distance=0.5)
    floor = cdsm.Mesh(name="floor", material=cdsm.Material(diffuse=(0.7, 0.7, 0.7)))
    floor.positions = np.array([[-3, -1.2, -3], [-3, -1.2, 3], [3, -1.2, 3], [3, -1.2, -3]], np.float32)
    floor.triangles = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
    return cdsm.Scene(camera=cdsm.Camera(position=(0, 1.5, 5)), image=cdsm.ImageSettings(width=180, height=120),
                      lights=[cdsm.Light(name="lamp", position=(0, 4, 0))], volumes=[fog], meshes=[floor])


def write_picture(path, image):
    """An image as 8 bits per channel, in sRGB."""
    linear = np.clip(image[..., :3], 0, 1)
    srgb = np.where(linear < 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    with open(path, "wb") as file:
        file.write(b"P6 %d %d 255\n" % (image.shape[1], image.shape[0]))
        file.write(np.round(255 * srgb).astype(np.uint8).tobytes())


def main():
    voxels = ball(0.5)
    scene = make_scene(voxels)
    engine = cdsm.Engine(warning=print)

    engine.prepare(scene)
    points = np.array([[0, 2, 0], [0, -1, 0], [9, 0, 0]], np.float32)
    above, below, outside = engine.transmittance("lamp", points)
    print(f"above {above:.3f}, below {below:.3f}, outside of the cone {outside:.0f}")

    image = engine.render(scene)
    print(f"{image.shape[1]} x {image.shape[0]} pixels in {engine.stats['time_ms']['total']:.0f} ms")
    if len(sys.argv) > 1:
        write_picture(sys.argv[1], image)

    voxels[:] = ball(0.9)
    scene.volumes[0].revision += 1  # the same array, other values
    engine.prepare(scene)
    later = engine.transmittance("lamp", points)[1]
    print(f"a time step later {later:.3f} below; {engine.stats['copied_bytes']} bytes were copied")
    return 0 if above == 1 and outside == -1 and 0 < later < below < 0.9 else 1


if __name__ == "__main__":
    sys.exit(main())
