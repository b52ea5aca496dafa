#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes teacups_01.toml to teacups_24.toml beside this script: arrays of steaming cups under one spot light, all with
the same camera, so that time can be plotted against the number of objects. They share one mesh and one volume."""
import pathlib

ARRAYS = ((1, 1), (2, 1), (2, 2), (4, 2), (4, 3), (4, 4), (6, 4))  # columns, rows
GAP = 1.35  # between cups; a saucer is 0.98 wide

SCENE = """\
# {title} The lights, the camera and the table are those
# of all scenes in this folder; written by make_scenes.py.

[camera]
position = [0.0, 6.6, 9.6]
target = [0.1, 0.1, -0.3]
fov = 31.5

[image]
width = 720
height = 480
background = [0.03, 0.035, 0.05]
ambient = [0.14, 0.15, 0.17]

[shadows]
technique = "deep-shadow-map"
map_size = 1024
tolerance = 0.01

[[light]]
name = "key"
position = [-9.0, 8.5, 5.0]
target = [-1.2, 0.0, -2.6]
cutoff = 42.0
color = [1.2, 1.11, 0.98]

[[material]]
name = "table"
diffuse = [0.5, 0.44, 0.38]

[[material]]
name = "porcelain"
diffuse = [0.74, 0.72, 0.68]
specular = [0.3, 0.3, 0.3]
shininess = 50.0

[[mesh]]
name = "table"
file = "../data/floor.obj"
material = "table"
scale = 20.0
"""

CUP = """
[[mesh]]
name = "cup {number}"
file = "../../demo/data/teacup.obj"
material = "porcelain"
position = [{x}, 0.0, {z}]
rotation = [0.0, 1.0, 0.0, {turn}]
scale = 0.5

[[volume]]
name = "steam {number}"
file = "../generated/steam.nrrd"
position = [{x}, 0.36, {z}]
rotation = [0.0, 1.0, 0.0, {turn}]
scale = 0.75
opacity = [[0.0, 0.0], [12.0, 0.012], [120.0, 0.2], [255.0, 0.4]]
color = [[0.0, 0.95, 0.96, 1.0]]
unit_distance = 0.1
shading = false
"""


def scene(columns, rows):
    count = columns * rows
    text = SCENE.format(title="One steaming teacup." if count == 1 else f"{count} steaming teacups.")
    for number in range(count):
        row, column = divmod(number, columns)
        text += CUP.format(number=number + 1, x=round(GAP * (column - 0.5 * (columns - 1)), 3),
                           z=round(GAP * (row - 0.5 * (rows - 1)), 3), turn=float((325 + 137 * number) % 360))
    return text


def main():
    for columns, rows in ARRAYS:
        path = pathlib.Path(__file__).with_name(f"teacups_{columns * rows:02}.toml")
        path.write_text(scene(columns, rows))
        print(path)


if __name__ == "__main__":
    main()
