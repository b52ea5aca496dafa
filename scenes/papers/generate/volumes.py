# SPDX-License-Identifier: Apache-2.0
"""Volumes of 8-bit voxels as arrays [z, y, x]; read and written as NRRD."""
import gzip

import numpy as np


def write_nrrd(path, voxels, spacing, origin, comment):
    """`spacing` and `origin` (the centre of the first voxel) are x, y, z."""
    depth, height, width = voxels.shape
    steps = " ".join("(" + ",".join(f"{spacing[i] if i == j else 0:.9g}" for j in range(3)) + ")" for i in range(3))
    head = (f"NRRD0004\n# {comment}\ntype: uint8\ndimension: 3\nspace dimension: 3\nsizes: {width} {height} {depth}\n"
            f"space directions: {steps}\nspace origin: ({','.join(f'{o:.9g}' for o in origin)})\n"
            "kinds: domain domain domain\nencoding: gzip\n\n")
    path.write_bytes(head.encode() + gzip.compress(np.ascontiguousarray(voxels).tobytes(), 6, mtime=0))


def read_nrrd(path):
    """Voxels and spacing of an 8-bit, gzip-encoded NRRD with axes along x, y and z."""
    head, body = path.read_bytes().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line and line[0] != "#")
    sizes = [int(word) for word in fields["sizes"].split()]
    rows = [[float(word) for word in row.strip("()").split(",")] for row in fields["space directions"].split()]
    voxels = np.frombuffer(gzip.decompress(body), np.uint8).reshape(sizes[::-1])
    return voxels, [rows[i][i] for i in range(3)]


def halved(voxels):
    """Means of 2 x 2 x 2 voxels."""
    depth, height, width = (size // 2 for size in voxels.shape)
    blocks = voxels[:2 * depth, :2 * height, :2 * width].reshape(depth, 2, height, 2, width, 2)
    return np.round(blocks.mean((1, 3, 5))).astype(np.uint8)
