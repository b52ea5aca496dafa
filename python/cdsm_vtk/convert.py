# SPDX-License-Identifier: Apache-2.0
"""Objects of VTK as those of a cdsm.Scene, for scripts that render or query with an engine of their own, too."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkRenderingCore import (VTK_CTF_LINEAR, VTK_CTF_RGB, vtkColorTransferFunction,
                                         vtkVolumeProperty)

import cdsm

TOLERANCE = 1e-3    # of opacities and colours, where VTK's curve is bent
MOST_HALVINGS = 13  # of the way between two nodes, for steps have no end
SHARES = 1024       # of the range of values: how far a function without clamping reaches past its end


def require(value, kind, what):
    """Raises TypeError unless the value is of this type; numbers are (float, int)."""
    if not isinstance(value, kind):
        name = "number" if isinstance(kind, tuple) else kind.__name__
        raise TypeError(f"{what} {value!r}, must be a {name}")


class _Curve:
    """A function of VTK, whichever of its two kinds: rows (value, opacity) or (value, red, green, blue)."""

    def __init__(self, function):
        self.of_colors = isinstance(function, vtkColorTransferFunction)
        self.function = function
        nodes = [[0.0] * (6 if self.of_colors else 4) for _ in range(function.GetSize())]
        for number, node in enumerate(nodes):
            function.GetNodeValue(number, node)
        self.rows = [np.array(node[:-2]) for node in nodes]
        self.bends = [tuple(node[-2:]) for node in nodes]  # midpoint and sharpness of the way to the next node
        if self.of_colors:
            self.straight = function.GetColorSpace() == VTK_CTF_RGB and function.GetScale() == VTK_CTF_LINEAR
        else:
            self.straight = not function.GetUseLogScale()

    def row_at(self, at):
        return np.array([at, *(self.function.GetColor(at) if self.of_colors else [self.function.GetValue(at)])])

    def bent(self, a, b, halvings=MOST_HALVINGS):
        """Rows behind a up to b, as many as it takes for straight lines to be near enough, judged at their quarters."""
        quarters = [self.row_at(a[0] + share * (b[0] - a[0])) for share in (0.25, 0.5, 0.75)]
        off = [np.abs(row - (a + share * (b - a)))[1:].max() for row, share in zip(quarters, (0.25, 0.5, 0.75))]
        if halvings == 0 or not max(off) > TOLERANCE:
            return [b]
        return self.bent(a, quarters[1], halvings - 1) + self.bent(quarters[1], b, halvings - 1)

    def points(self):
        """Rows with straight lines in between."""
        points = self.rows[:1]
        for a, b, (midpoint, sharpness) in zip(self.rows, self.rows[1:], self.bends):
            if not b[0] > a[0] or self.straight and (midpoint, sharpness) == (0.5, 0):
                points.append(b)
            else:
                corner = self.row_at(a[0] + midpoint * (b[0] - a[0]))
                points += self.bent(a, corner) + self.bent(corner, b)
        if self.function.GetClamping() or not points:
            return points
        return _with_ends(points, all(row[0] == np.floor(row[0]) for row in self.rows))


def _with_ends(points, whole):
    """With steps to 0 at both ends. The last value counts as inside, so the upper step lies a little above it: by one
    where all values are whole ones, as labels are."""
    first, last = points[0], points[-1]
    span = last[0] - first[0]
    past = last[0] + (1 if whole else (span or max(abs(last[0]), 1)) / SHARES)
    zeros = [0.0] * (len(first) - 1)
    return [[first[0], *zeros], *points, [past, *last[1:]], [past, *zeros]]


def transfer_function(volume_property):
    """A vtkVolumeProperty's component 0 as cdsm.TransferFunction, right to 0.001 where its curves are bent."""
    require(volume_property, vtkVolumeProperty, "the volume property is")
    if volume_property.GetTransferFunctionMode() != vtkVolumeProperty.TF_1D:
        raise cdsm.Error("the transfer function is of two dimensions, must be of one (SetTransferFunctionMode(TF_1D))")
    if not volume_property.GetDisableGradientOpacity() and volume_property.HasGradientOpacity():
        if any(opacity != 1 for _, opacity in _Curve(volume_property.GetStoredGradientOpacity()).rows):
            raise cdsm.Error("opacity depends on the gradient, must not (DisableGradientOpacityOn())")
    if volume_property.GetColorChannels() == 1:
        color = [(x, grey, grey, grey) for x, grey in _Curve(volume_property.GetGrayTransferFunction()).points()]
    else:
        color = _Curve(volume_property.GetRGBTransferFunction()).points()
    return cdsm.TransferFunction(opacity=_Curve(volume_property.GetScalarOpacity()).points(), color=color,
                                 unit_distance=volume_property.GetScalarOpacityUnitDistance())


def world_from_index(image):
    """From indices that begin with the extent to the world."""
    matrix = image.GetIndexToPhysicalMatrix()
    return np.array([[matrix.GetElement(row, column) for column in range(4)] for row in range(4)])


def volume(image, scalars):
    """A vtkImageData with one of its arrays of points, read in place, as cdsm.Volume without transfer function."""
    require(image, vtkImageData, "the image is")
    require(scalars, vtkDataArray, "the scalars are")
    name = scalars.GetName() or "scalars"
    if scalars.GetNumberOfComponents() != 1:
        raise cdsm.Error(f"the array '{name}' has {scalars.GetNumberOfComponents()} components, must have one; "
                         "vtkImageExtractComponents takes one out")
    if scalars.GetNumberOfTuples() != image.GetNumberOfPoints():
        raise cdsm.Error(f"the array '{name}' has {scalars.GetNumberOfTuples()} values for "
                         f"{image.GetNumberOfPoints()} points, must have one for each")
    if not scalars.HasStandardMemoryLayout():
        raise cdsm.Error(f"the array '{name}' does not lie side by side in memory, must be such one as vtkFloatArray")
    voxels = vtk_to_numpy(scalars)
    if voxels.dtype not in (np.float32, np.uint8, np.int8, np.uint16, np.int16):
        raise cdsm.Error(f"the array '{name}' is {voxels.dtype}, must be float32, int8, uint8, int16 or uint16; "
                         "vtkImageCast (in ParaView a Calculator whose result is of type Float) makes such a copy")
    shift = np.eye(4)
    shift[:3, 3] = image.GetExtent()[::2]
    # not the voxels' own matrix: a grid that moves needs no other voxels
    return cdsm.Volume(name=name, voxels=voxels.reshape(image.GetDimensions()[::-1]),
                       world_from_object=world_from_index(image) @ shift)


def mesh(surface):
    """Polygons and strips of a vtkPolyData as cdsm.Mesh, points in place if they are floats; None without triangles."""
    require(surface, vtkPolyData, "the surface is")
    count = surface.GetNumberOfPoints()
    points = vtk_to_numpy(surface.GetPoints().GetData()) if count else np.zeros((0, 3))
    if not np.isfinite(points).all():
        wrong = np.argmin(np.isfinite(points).all(axis=1))
        raise cdsm.Error(f"point {wrong} of a surface is not finite, must be numbers")
    for cells in surface.GetPolys(), surface.GetStrips():
        corners = vtk_to_numpy(cells.GetConnectivityArray()) if cells.GetNumberOfConnectivityIds() else np.zeros(0)
        for wrong in corners[(corners < 0) | (corners >= count)][:1]:
            raise cdsm.Error(f"a cell of a surface has the point {wrong}, must be in 0 to {count - 1}")
    triangulate = vtkTriangleFilter()
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.SetInputData(surface)
    triangulate.Update()
    triangles = triangulate.GetOutput()
    if triangles.GetNumberOfPolys() == 0:
        return None
    corners = vtk_to_numpy(triangles.GetPolys().GetConnectivityArray())
    return cdsm.Mesh(positions=vtk_to_numpy(triangles.GetPoints().GetData()).astype(np.float32, copy=False),
                     triangles=corners.reshape(-1, 3).astype(np.uint32))
