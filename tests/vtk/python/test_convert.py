# SPDX-License-Identifier: Apache-2.0
"""Transfer functions of VTK as those of cdsm, against VTK's own values."""
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

import cdsm_vtk


def function_of(*points, **settings):
    function = vtkPiecewiseFunction()
    for name, value in settings.items():
        getattr(function, "Set" + name)(value)
    for point in points:
        function.AddPoint(*point)
    return function


def converted(opacity, color=None):
    volume_property = vtkVolumeProperty()
    volume_property.SetScalarOpacity(opacity)
    volume_property.SetScalarOpacityUnitDistance(3.5)
    if color:
        volume_property.SetColor(color)
    return cdsm_vtk.transfer_function(volume_property)


class Convert(unittest.TestCase):
    def expect_values(self, function, where, rows=None):
        table = np.array(rows or converted(function).opacity)
        np.testing.assert_allclose(np.interp(where, table[:, 0], table[:, 1]),
                                   [function.GetValue(x) for x in where], atol=0.002)

    def test_nodes_are_taken_as_they_are(self):
        transfer = converted(function_of((-5, 0.25), (3, 0.75), (3, 0.5), (10, 1), AllowDuplicateScalars=1))
        self.assertEqual(transfer.opacity, ((-5, 0.25), (3, 0.75), (3, 0.5), (10, 1)))
        self.assertEqual(transfer.unit_distance, 3.5)

    def test_bent_opacities_are_followed(self):
        for sharpness in 0, 0.3, 0.8:
            for midpoint in 0.5, 0.2:
                self.expect_values(function_of((-1, 0, midpoint, sharpness), (4, 1, midpoint, sharpness), (7, 0.3)),
                                   np.linspace(-2, 8, 1000))
        self.expect_values(function_of((1, 0), (1000, 1), UseLogScale=True), np.geomspace(1, 1000, 500))
        step = function_of((0, 0.1, 0.5, 1), (8, 0.9))
        self.expect_values(step, [1, 3.99, 4.01, 7])
        self.assertLess(len(converted(step).opacity), 50)

    def test_functions_are_zero_beyond_their_ends_without_clamping(self):
        for first, past in (10, 21), (10.5, 20.01):
            function = function_of((first, 0.5), (20, 0.75), Clamping=0)
            rows = np.array(converted(function).opacity)
            around = np.interp([first - 0.001, 20, past], rows[:, 0], rows[:, 1])
            np.testing.assert_allclose(around, [0, 0.75, 0], atol=1e-6)
            np.testing.assert_allclose(rows[:2], [(first, 0), (first, 0.5)])

    def test_colors_are_followed_in_their_space(self):
        color = vtkColorTransferFunction()
        color.AddRGBPoint(0, 0.9, 0.2, 0.1)
        color.AddRGBPoint(5, 0.1, 0.3, 0.8)
        self.assertEqual(len(converted(function_of((0, 0)), color).color), 2)
        where = np.linspace(-1, 6, 700)
        for space in range(4):  # RGB, HSV, Lab, diverging
            color.SetColorSpace(space)
            rows = np.array(converted(function_of((0, 0)), color).color)
            for channel in range(3):
                np.testing.assert_allclose(np.interp(where, rows[:, 0], rows[:, 1 + channel]),
                                           [color.GetColor(x)[channel] for x in where], atol=0.002)

    def test_grey_is_understood(self):
        volume_property = vtkVolumeProperty()
        volume_property.SetColor(function_of((2, 0.25)))
        self.assertEqual(cdsm_vtk.transfer_function(volume_property).color, ((2, 0.25, 0.25, 0.25),))


if __name__ == "__main__":
    unittest.main()
