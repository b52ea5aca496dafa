# SPDX-License-Identifier: Apache-2.0
"""Takes the sports car apart, which comes as one mesh without materials: paint, glass, tyres, rims and the rest; and
opens the lid above its engine. The car looks along +z, x is its left, units are metres."""
import numpy as np

from . import meshes

# Connected parts by number (meshes.components of the file); the rest is trim, engine and interior.
CABIN = 266  # canopy, seats, floor
PAINT = (1, 137, 95, 1042, 557, 291)
REAR = 1
TYRES = (2, 1159, 136, 1091)
RIMS = (3, 1160, 139, 1092)
INSIDE = ((-0.74, 0.63, -0.9), (0.74, 1.08, 1.2))  # of the canopy: emptied, so that light crosses the car
HATCH = {"x": 0.34, "back": -1.62, "front": -0.78, "above": 0.6}  # cut out of the rear: engine below


def smooth_areas(points, triangles, angle=20.0):
    """For each triangle the area of the smooth part that it belongs to: neighbours that differ by less than `angle`."""
    areas = meshes.face_normals(points, triangles)
    facing = meshes.unit(areas)
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), 1)
    key = edges[:, 0] * len(points) + edges[:, 1]
    order = np.argsort(key, kind="stable")
    pair = key[order][1:] == key[order][:-1]
    a, b = order[1:][pair] // 3, order[:-1][pair] // 3
    soft = np.einsum("ij,ij->i", facing[a], facing[b]) > np.cos(np.radians(angle))
    label = meshes.linked(len(triangles), a[soft], b[soft])
    return np.bincount(label, 0.5 * np.linalg.norm(areas, axis=1))[label]


def canopy(points, triangles):
    """Masks of roof and windows among the triangles of the cabin. Roof and windscreen are its largest smooth surface,
    parted at a line of the mesh; each side window is a pane that leans inwards like the line |x| + 0.96 y = 1.4."""
    corners = points[triangles]
    across, up, along = np.abs(corners[..., 0]), corners[..., 1], corners[..., 2]
    area = smooth_areas(points, triangles)
    shell = area == area.max()
    front = (along >= np.minimum(0.7, 0.735 - 0.335 * across)).all(1)
    tilt = np.abs(meshes.unit(meshes.face_normals(points, triangles))[:, 0])
    leaning = (np.abs(across + 0.96 * up - 1.4) < 0.06).all(1) & (tilt > 0.45) & (tilt < 0.93) & ~shell
    panes = np.flatnonzero(leaning)
    side = np.zeros(len(triangles), bool)
    side[panes[smooth_areas(points, triangles[panes]) > 0.1]] = True
    return shell & ~front, shell & front | side


def cut(points, triangles, normal, offset):
    """Splits at the plane normal . p = offset: the mesh in front of it and the mesh behind it."""
    height = points @ np.asarray(normal, float) - offset
    above = height[triangles] > 0.0
    count = above.sum(1)
    new_points, front, back = [points], [triangles[count == 3]], [triangles[count == 0]]
    total = len(points)
    for ones, lone_side, other_side in ((1, front, back), (2, back, front)):
        crossed = np.flatnonzero(count == ones)
        lone = np.argmax(above[crossed] == (ones == 1), axis=1)
        a, b, c = (triangles[crossed, (lone + i) % 3] for i in range(3))
        ends = []
        for end in (b, c):
            share = (height[a] / (height[a] - height[end]))[:, None]
            new_points.append(points[a] + share * (points[end] - points[a]))
            ends.append(total + np.arange(len(crossed)))
            total += len(crossed)
        lone_side.append(np.column_stack([a, ends[0], ends[1]]))
        other_side += [np.column_stack([ends[0], b, c]), np.column_stack([ends[0], c, ends[1]])]
    return np.vstack(new_points), np.vstack(front), np.vstack(back)


def opened(points, triangles):
    """The painted rear with an opening above the engine; the lid is gone."""
    corners = points[triangles]
    x, z = corners[..., 0], corners[..., 2]
    near = ((corners[..., 1] > HATCH["above"]).all(1) & (x.min(1) < HATCH["x"])
            & (x.max(1) > -HATCH["x"]) & (z.min(1) < HATCH["front"]) & (z.max(1) > HATCH["back"]))
    body, lid = [(points, triangles[~near])], (points, triangles[near])
    for normal, offset in (((1, 0, 0), -HATCH["x"]), ((-1, 0, 0), -HATCH["x"]), ((0, 0, 1), HATCH["back"]),
                           ((0, 0, -1), -HATCH["front"])):
        places, inside, outside = cut(*lid, normal, offset)
        body.append((places, outside))
        lid = places, inside
    return meshes.merged(body)


def parts(path):
    """Name -> (points, triangles) of paint, the same without engine lid, glass, tyres, rims and trim."""
    points, triangles = meshes.read_ply(path)
    number = meshes.components(points, triangles)
    roof, glass = np.zeros((2, len(triangles)), bool)
    cabin = number == CABIN
    roof[cabin], glass[cabin] = canopy(points, triangles[cabin])
    paint = np.isin(number, PAINT) | roof
    tyres, rims = np.isin(number, TYRES), np.isin(number, RIMS)
    rear = number == REAR
    middle = points[triangles].mean(1)
    inside = ((middle > INSIDE[0]) & (middle < INSIDE[1])).all(1)
    lining = cabin & (middle[:, 1] > 0.93) & (np.abs(middle[:, 0]) < 0.45) & (middle[:, 2] < 0.75)
    outside = ~cabin & (middle[:, 1] > 0.94 - 0.42 * np.maximum(middle[:, 2] - 0.71, 0.0))  # the wiper
    inside &= ~lining & ~outside
    without_lid = meshes.merged([meshes.kept(points, triangles, paint & ~rear),
                                 opened(*meshes.kept(points, triangles, rear))])
    masks = {"paint": paint, "glass": glass, "tyres": tyres, "rims": rims,
             "trim": ~(paint | glass | tyres | rims | inside)}
    return {"paint_open": without_lid, **{name: meshes.kept(points, triangles, mask) for name, mask in masks.items()}}
