# SPDX-License-Identifier: Apache-2.0
"""The points of any data set as rows of a NumPy array."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPointSet, vtkRectilinearGrid

import cdsm
from cdsm_vtk.convert import world_from_index

MOST_OF_THE_WAY = 0.999  # where the light is itself, there is no way from it


def _grid_points(dataset, first, last):
    """World points of an image or rectilinear grid, by their numbers."""
    index = np.unravel_index(np.arange(first, last), dataset.GetDimensions()[::-1])[::-1]
    if isinstance(dataset, vtkImageData):
        matrix = world_from_index(dataset)
        index = np.stack(index, axis=1) + np.array(dataset.GetExtent()[::2])
        return index @ matrix[:3, :3].T + matrix[:3, 3]
    axes = dataset.GetXCoordinates(), dataset.GetYCoordinates(), dataset.GetZCoordinates()
    return np.stack([vtk_to_numpy(axis)[i] for axis, i in zip(axes, index)], axis=1)


def points_between(dataset, first, last):
    """World points of any data set, by their numbers."""
    if isinstance(dataset, (vtkImageData, vtkRectilinearGrid)):
        return _grid_points(dataset, first, last)
    if isinstance(dataset, vtkPointSet):
        return vtk_to_numpy(dataset.GetPoints().GetData())[first:last]
    raise cdsm.Error(f"the points of a {dataset.GetClassName()} cannot be read; vtkAppendFilter makes a "
                     "vtkUnstructuredGrid of it")


def moved(points, light, bias):
    """Points by `bias` world units nearer to the light, but not past it."""
    if light.type == "directional":
        return points - bias * np.array(light.direction) / np.linalg.norm(light.direction)
    way = np.array(light.position) - points
    length = np.linalg.norm(way, axis=1, keepdims=True)
    return points + way * (np.minimum(bias, MOST_OF_THE_WAY * length) / np.maximum(length, 1e-30))
