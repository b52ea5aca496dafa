# SPDX-License-Identifier: Apache-2.0
"""Small pipelines whose light is known by formula, as those of ../pipelines.hpp."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkLogger, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPiecewiseFunction, vtkPolyData

OPACITY, UNIT_DISTANCE = 0.25, 0.5  # of voxels of the value 1
NEAR = 0.003                        # the tolerance of the maps, and what their steps leave
LOWEST = 4 + 8 * (15 + 16 * 3)      # of filled_image(): amid its lowest points


def filled_image(kind=VTK_FLOAT):
    """A filled box whose extent begins below and above 0, with axes exchanged and turned around."""
    image = vtkImageData()
    image.SetExtent(-3, 4, 5, 20, 2, 7)
    image.SetOrigin(1, 2, -3)
    image.SetSpacing(0.5, 0.125, 0.25)
    image.SetDirectionMatrix(0, 0, 1, 0, -1, 0, 1, 0, 0)  # j runs down the world's y
    image.AllocateScalars(kind, 1)
    image.GetPointData().GetScalars().SetName("density")
    image.GetPointData().GetScalars().Fill(1)
    return image


def points_of(dataset):
    return np.array([dataset.GetPoint(i) for i in range(dataset.GetNumberOfPoints())])


def expected(image, heights):
    """What of light from above gets to heights in the image's box, half a voxel beyond its outer centres."""
    low, high = image.GetBounds()[2] - 0.0625, image.GetBounds()[3] + 0.0625
    return (1 - OPACITY) ** ((high - np.clip(heights, low, high)) / UNIT_DISTANCE)


def set_up(shadows):
    """Light from above, opacities from 0 to OPACITY."""
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(1, OPACITY)
    shadows.GetVolumeProperty().SetScalarOpacity(opacity)
    shadows.GetVolumeProperty().SetScalarOpacityUnitDistance(UNIT_DISTANCE)
    shadows.SetLightType("directional")
    shadows.SetMapSize(64)
    shadows.SetTolerance(0.001)
    return shadows


def square(height):
    """One polygon in the plane y = height above or below all of the image; its last point is one amid it."""
    points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    for x, z in (-9, -9), (-9, 9), (9, 9), (9, -9), (0, 1):
        points.InsertNextPoint(x, height, z)
    cells.InsertNextCell(4, [0, 1, 2, 3])
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def values_of(shadows, name="Transmittance"):
    """The array of the filter's output; None if it has none."""
    array = shadows.GetOutput().GetPointData().GetArray(name)
    return array and vtk_to_numpy(array)


def errors_of(shadows):
    """A list that gets the filter's errors; what executives add to them is kept off the screen."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    errors = []

    def gather(_caller, _event, text):
        errors.append(text)
    gather.CallDataType = "string0"
    shadows.AddObserver("ErrorEvent", gather)
    return errors
