# SPDX-License-Identifier: Apache-2.0
"""Wrong input gets an error that says what would be right, an output without the array, and a filter that works on."""
import math
import unittest

from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, VTK_INT, vtkFloatArray, vtkSOADataArrayTemplate
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkDataSetAttributes, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

import cdsm
import cdsm_vtk
import pipelines

POINTS, CELLS = vtkDataObject.FIELD_ASSOCIATION_POINTS, vtkDataObject.FIELD_ASSOCIATION_CELLS


def only_cells(image):
    cells = vtkFloatArray()
    cells.SetNumberOfValues(image.GetNumberOfCells())
    image.GetPointData().Initialize()
    image.GetCellData().AddArray(cells)


def scattered(image):
    array = vtkSOADataArrayTemplate["float32"]()
    array.SetNumberOfComponents(1)
    array.SetNumberOfTuples(image.GetNumberOfPoints())
    array.Fill(1)
    image.GetPointData().SetScalars(array)


def opacity_of(shadows, value):
    function = vtkPiecewiseFunction()
    function.AddPoint(1, value)
    shadows.GetVolumeProperty().SetScalarOpacity(function)


def gradient_of(shadows):
    function = vtkPiecewiseFunction()
    function.AddPoint(0, 0.5)
    shadows.GetVolumeProperty().SetGradientOpacity(function)


def corner_of(surface, index):
    cells = vtkCellArray()
    cells.InsertNextCell(3, [0, 1, index])
    surface.SetPolys(cells)


# What is done to the filter, the image or the surface, and what the error says.
WRONG = [
    (lambda f, i, s: i.GetPointData().Initialize(), "has no scalars of its points"),
    (lambda f, i, s: only_cells(i), "vtkCellDataToPointData"),
    (lambda f, i, s: f.SetInputArrayToProcess(0, 0, 0, CELLS, "cells"), "of its cells, must be of its points"),
    (lambda f, i, s: f.SetInputArrayToProcess(0, 0, 0, POINTS, "missing"), r"not those of SetInputArrayToProcess\(\)"),
    (lambda f, i, s: i.AllocateScalars(VTK_DOUBLE, 1), "is float64, must be float32"),
    (lambda f, i, s: i.AllocateScalars(VTK_INT, 1), "is int32, must be float32"),
    (lambda f, i, s: i.AllocateScalars(VTK_FLOAT, 3), "has 3 components, must have one"),
    (lambda f, i, s: i.GetPointData().GetScalars().SetNumberOfTuples(7), "has 7 values for 768 points"),
    (lambda f, i, s: scattered(i), "does not lie side by side"),
    (lambda f, i, s: i.GetPointData().GetScalars().SetComponent(5, 0, math.nan), "is not finite"),
    (lambda f, i, s: i.SetSpacing(1, 0, 1), "the transform cannot be inverted"),
    (lambda f, i, s: i.SetOrigin(math.nan, 0, 0), "cannot be inverted"),
    (lambda f, i, s: opacity_of(f, 1.5), "opacity is 1.5"),
    (lambda f, i, s: opacity_of(f, math.nan), "opacity is nan"),
    (lambda f, i, s: f.SetScalarOpacity(None), "opacity has no points"),
    (lambda f, i, s: f.SetScalarOpacityUnitDistance(0), "unit_distance is 0"),
    (lambda f, i, s: gradient_of(f), "opacity depends on the gradient"),
    (lambda f, i, s: f.GetVolumeProperty().SetTransferFunctionMode(1), "is of two dimensions"),
    (lambda f, i, s: f.SetLightDirection(0, 0, 0), "has no length"),
    (lambda f, i, s: f.SetLightDirection(math.nan, 0, 0), "direction is nan"),
    (lambda f, i, s: f.SetTechnique("magic"), "magic"),
    (lambda f, i, s: f.SetMapSize(0), "map_size is 0"),
    (lambda f, i, s: f.SetTolerance(math.nan), "tolerance is nan"),
    (lambda f, i, s: f.SetDevice("no such device"), "no such device"),
    (lambda f, i, s: f.SetDevice(5), "device is 5, must be a str"),
    (lambda f, i, s: f.SetArrayName(5), "array name is 5, must be a str"),
    (lambda f, i, s: f.SetSurfaceOpacity(2), "opacity is 2"),
    (lambda f, i, s: f.SetSurfaceOpacity("much"), "opacity is 'much', must be a number"),
    (lambda f, i, s: f.SetShadows("good"), "shadows is 'good', must be a ShadowSettings"),
    (lambda f, i, s: s.GetPoints().SetPoint(2, math.nan, 0, 0), "point 2 of a surface"),
    (lambda f, i, s: corner_of(s, 9), "has the point 9, must be in 0 to 4"),
    (lambda f, i, s: f.SetLightType("lamp"), "Light.type is 'lamp'"),
    (lambda f, i, s: f.SetLightType(3), "Light.type is 3"),
    (lambda f, i, s: f.SetLightPosition(1, 2, "up"), "must be three numbers"),
    (lambda f, i, s: f.SetLightCutoff(None), "Light.cutoff is None"),
    (lambda f, i, s: f.SetMapSize(1.5), "map_size is 1.5, must be an integer"),
    (lambda f, i, s: f.SetTechnique(None), "technique is None"),
    (lambda f, i, s: f.SetVolumeProperty(None), "must be a vtkVolumeProperty"),
]


class WrongInput(unittest.TestCase):
    def mended(self, shadows):
        shadows.SetVolumeProperty(vtkVolumeProperty())
        shadows.SetLightDirection(0, -1, 0)
        shadows.SetShadows(cdsm.ShadowSettings())
        shadows.SetDevice("")
        shadows.SetArrayName("Transmittance")
        shadows.SetSurfaceOpacity(0)
        shadows.SetInputArrayToProcess(0, 0, 0, POINTS, vtkDataSetAttributes.SCALARS)
        image = pipelines.filled_image()
        shadows.SetInputData(image)
        shadows.SetInputData(1, pipelines.square(30))
        pipelines.set_up(shadows).Update()
        expected = pipelines.expected(image, image.GetPoint(pipelines.LOWEST)[1])
        self.assertAlmostEqual(pipelines.values_of(shadows)[pipelines.LOWEST], expected, delta=pipelines.NEAR)

    def test_it_is_told_and_forgiven(self):
        for number, (spoil, message) in enumerate(WRONG):
            shadows, image, surface = cdsm_vtk.vtkCdsmShadowFilter(), pipelines.filled_image(), pipelines.square(30)
            pipelines.set_up(shadows)
            shadows.SetInputData(image)
            shadows.AddInputData(1, surface)
            shadows.Update()
            errors = pipelines.errors_of(shadows)
            with self.subTest(number=number, message=message):
                try:
                    spoil(shadows, image, surface)
                except (TypeError, cdsm.Error) as error:  # told at once
                    errors.append(str(error))
                else:
                    image.Modified()
                    surface.Modified()
                    shadows.Update()
                    self.assertIsNone(pipelines.values_of(shadows))
                self.assertRegex("\n".join(errors), message)
                self.mended(shadows)

    def test_it_is_told_of_conversions(self):
        image = pipelines.filled_image()
        for convert, message in [
                (lambda: cdsm_vtk.transfer_function(None), "property is None, must be a vtkVolumeProp"),
                (lambda: cdsm_vtk.volume(None, None), "image is None, must be a vtkImageData"),
                (lambda: cdsm_vtk.volume(image, image), "scalars are .*, must be a vtkDataArray"),
                (lambda: cdsm_vtk.mesh(image), "surface is .*, must be a vtkPolyData")]:
            with self.assertRaisesRegex(TypeError, message):
                convert()

    def test_it_is_told_of_queries(self):
        query, asked = cdsm_vtk.vtkCdsmTransmittanceFilter(), pipelines.square(0)
        errors = pipelines.errors_of(query)
        asked.GetPoints().SetPoint(1, math.nan, 0, 0)
        query.SetInputData(asked)
        query.Update()
        self.assertRegex(errors[-1], "point 1 ")
        asked.GetPoints().SetPoint(1, 0, 0, 0)
        asked.GetPoints().Modified()
        query.SetBias(-1)
        query.Update()
        self.assertRegex(errors[-1], "Bias is -1")
        with self.assertRaisesRegex(TypeError, "Bias is 'big', must be a number"):
            query.SetBias("big")
        query.SetBias(0)
        query.SetShadows(cdsm.ShadowSettings(transmittance="rgb"))
        query.Update()
        self.assertRegex(errors[-1], "must be 'grey'")
        query.SetShadows(cdsm.ShadowSettings())
        query.Update()
        self.assertEqual(len(pipelines.values_of(query)), 5)


if __name__ == "__main__":
    unittest.main()
