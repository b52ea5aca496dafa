# SPDX-License-Identifier: Apache-2.0
"""Triangle meshes as two arrays: points (n, 3) and triangles (m, 3); read and written as binary PLY."""
import gzip

import numpy as np

FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])


def read_ply(path):
    """A little-endian binary PLY of float x, y, z and triangles, compressed or not."""
    with (gzip.open if path.suffix == ".gz" else open)(path, "rb") as file:
        content = file.read()
    head, body = content.split(b"end_header\n", 1)
    counts = {line.split()[1]: int(line.split()[2]) for line in head.splitlines() if line.startswith(b"element")}
    vertices, faces = counts[b"vertex"], counts[b"face"]
    points = np.frombuffer(body, "<f4", 3 * vertices).reshape(-1, 3).astype(float)
    triangles = np.frombuffer(body, FACE, faces, 12 * vertices)["corners"].astype(np.int64)
    return points, triangles


def write_ply(path, points, triangles, normals):
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
            + "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
            + f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    faces = np.empty(len(triangles), FACE)
    faces["count"] = 3
    faces["corners"] = triangles
    path.write_bytes(head.encode() + np.hstack([points, normals]).astype("<f4").tobytes() + faces.tobytes())


def face_normals(points, triangles):
    """Normals whose lengths are twice the areas of the triangles."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def unit(vectors):
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0.0, length, 1.0)


def joined(points, triangles):
    """Vertices at equal places become one; triangles that lose their area go."""
    places, index = np.unique(np.round(points, 6), axis=0, return_inverse=True)
    triangles = index[triangles]
    a, b, c = triangles.T
    return places, triangles[(a != b) & (b != c) & (c != a)]


def smooth(points, triangles, crease=40.0):
    """Points, triangles and normals: edges stay sharp where the surface turns by more than `crease` degrees."""
    areas = face_normals(points, triangles)
    facing = unit(areas)
    corners = triangles.ravel()
    order = np.argsort(corners, kind="stable")
    count = np.bincount(corners, minlength=len(points))
    start = np.cumsum(count) - count
    fan = count[corners]  # how many corners share this corner's vertex
    mine = np.repeat(np.arange(len(corners)), fan)
    other = order[start[corners[mine]] + np.arange(len(mine)) - np.repeat(np.cumsum(fan) - fan, fan)]
    soft = np.einsum("ij,ij->i", facing[mine // 3], facing[other // 3]) > np.cos(np.radians(crease))
    mine, other = mine[soft], other[soft]
    normals = np.stack([np.bincount(mine, areas[other // 3, i], len(corners)) for i in range(3)], 1)
    keys = np.column_stack([corners, np.round(unit(normals) * 500.0)]).astype(np.int64)
    _, first, index = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return points[corners[first]], index.reshape(-1, 3), unit(normals[first])


def linked(count, first, second):
    """Numbers 0 ... of the groups into which the pairs (first, second) link `count` things."""
    label = np.arange(count)
    while True:
        lower = label.copy()
        np.minimum.at(lower, first, label[second])
        np.minimum.at(lower, second, label[first])
        lower = lower[lower]
        if np.array_equal(lower, label):
            return np.unique(label, return_inverse=True)[1]
        label = lower


def components(points, triangles):
    """Number of the connected part that each triangle belongs to, counted from 0."""
    label = linked(len(points), triangles[:, [0, 1]].ravel(), triangles[:, [1, 2]].ravel())
    return np.unique(label[triangles[:, 0]], return_inverse=True)[1]


def kept(points, triangles, mask):
    """The mesh of the triangles for which `mask` holds, without unused points."""
    used, index = np.unique(triangles[mask], return_inverse=True)
    return points[used], index.reshape(-1, 3)


def merged(parts):
    """One mesh out of several (points, triangles)."""
    offsets = np.cumsum([0] + [len(points) for points, _ in parts])
    return (np.vstack([points for points, _ in parts]),
            np.vstack([triangles + offset for (_, triangles), offset in zip(parts, offsets)]))


def save_smooth(path, points, triangles, crease=40.0):
    write_ply(path, *smooth(*joined(points, triangles), crease))
