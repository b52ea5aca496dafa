# SPDX-License-Identifier: Apache-2.0
"""The filters of cdsm_vtk against formulas and against the engine itself."""
import gc
import itertools
import unittest
import weakref

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (VTK_CHAR, VTK_DOUBLE, VTK_FLOAT, VTK_SHORT, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR,
                                      VTK_UNSIGNED_SHORT, vtkPoints)
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkRectilinearGrid, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkStripper, vtkTriangleFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

import cdsm
import cdsm_vtk
import pipelines


class Filters(unittest.TestCase):
    def setUp(self):
        self.image = pipelines.filled_image()
        self.shadows = pipelines.set_up(cdsm_vtk.vtkCdsmShadowFilter())
        self.shadows.SetInputData(self.image)

    def lowest(self):
        self.shadows.Update()
        return pipelines.values_of(self.shadows)[pipelines.LOWEST]

    def expect_lowest(self, surfaces=1.0):
        height = self.image.GetPoint(pipelines.LOWEST)[1]
        self.assertAlmostEqual(self.lowest(), surfaces * pipelines.expected(self.image, height), delta=pipelines.NEAR)

    def test_voxels_are_read_in_place_wherever_the_grid_lies(self):
        for kind in (VTK_UNSIGNED_CHAR, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_SHORT, VTK_FLOAT):
            image = pipelines.filled_image(kind)
            self.shadows.SetInputData(image)
            self.shadows.Update()
            expected = pipelines.expected(image, pipelines.points_of(image)[:, 1])
            np.testing.assert_allclose(pipelines.values_of(self.shadows), expected, atol=pipelines.NEAR)
            self.assertEqual(self.shadows.GetStats()["copied_bytes"], 0)
            self.assertEqual(self.shadows.GetOutput().GetPointData().GetScalars().GetName(), "density")

    def test_they_give_what_the_engine_gives(self):
        spot = {"position": (2, 4, -3), "target": (2, 0, -3), "cutoff": 20}
        self.shadows.SetLightType("spot")
        self.shadows.SetLightPosition(*spot["position"])
        self.shadows.SetLightTarget(*spot["target"])
        self.shadows.SetLightCutoff(spot["cutoff"])
        self.shadows.Update()
        matrix = np.array([[0, 0, 0.25, 0], [0, -0.125, 0, 0], [0.5, 0, 0, 0], [0, 0, 0, 1]], float)
        matrix[:3, 3] = self.image.GetPoint(0)
        transfer = cdsm.TransferFunction(opacity=[(0, 0), (1, pipelines.OPACITY)], color=[(0, 0, 0, 0)],
                                         unit_distance=pipelines.UNIT_DISTANCE)
        voxels = cdsm.Volume(voxels=np.ones((6, 16, 8), np.float32), transfer=transfer, world_from_object=matrix)
        engine = cdsm.Engine()
        engine.prepare(cdsm.Scene(volumes=[voxels], lights=[cdsm.Light(name="lamp", **spot)],
                                  shadows=cdsm.ShadowSettings(map_size=64, tolerance=0.001)))
        expected = engine.transmittance("lamp", pipelines.points_of(self.image).astype(np.float32))
        self.assertTrue(0 < (expected == -1).sum() < len(expected))
        np.testing.assert_array_equal(pipelines.values_of(self.shadows), np.maximum(expected, 0))

    def asked(self, kind):
        """Points from above the image to below it."""
        bounds = self.image.GetBounds()
        x, z, heights = bounds[0] + 0.5, bounds[4] + 0.7, np.linspace(bounds[2] - 2, bounds[3] + 1, 5)
        if kind == "grid":
            grid = vtkRectilinearGrid()
            grid.SetDimensions(1, 5, 1)
            for axis, values in zip("XYZ", ([x], heights, [z])):
                getattr(grid, f"Set{axis}Coordinates")(numpy_to_vtk(np.array(values), deep=True))
            return grid
        grid, points = vtkUnstructuredGrid(), vtkPoints()
        points.SetDataType(kind)
        for height in heights:
            points.InsertNextPoint(x, height, z)
        grid.SetPoints(points)
        return grid

    def test_they_answer_for_points_of_any_dataset(self):
        query = pipelines.set_up(cdsm_vtk.vtkCdsmTransmittanceFilter())
        query.SetInputData(1, self.image)
        for asked in self.asked("grid"), self.asked(VTK_FLOAT), self.asked(VTK_DOUBLE), self.image:
            query.SetInputData(asked)
            query.Update()
            self.assertEqual(query.GetOutput().GetClassName(), asked.GetClassName())
            expected = pipelines.expected(self.image, pipelines.points_of(asked)[:, 1])
            np.testing.assert_allclose(pipelines.values_of(query), expected, atol=pipelines.NEAR)

    def test_surfaces_multiply(self):
        triangles, strips = vtkTriangleFilter(), vtkStripper()
        triangles.SetInputData(pipelines.square(1))
        strips.SetInputConnection(triangles.GetOutputPort())
        query = pipelines.set_up(cdsm_vtk.vtkCdsmTransmittanceFilter())
        query.SetSurfaceOpacity(0.5)
        query.AddInputConnection(2, strips.GetOutputPort())
        for surface in pipelines.square(0), vtkPolyData():
            query.AddInputData(2, surface)
        points, asked = vtkPoints(), vtkPolyData()
        for height in 2, 0.5, -1:
            points.InsertNextPoint(0.3, height, 0.2)
        asked.SetPoints(points)
        query.SetInputData(asked)
        query.Update()
        np.testing.assert_array_equal(pipelines.values_of(query), [1, 0.5, 0.25])

    def test_bias_moves_points_towards_the_light(self):
        query = pipelines.set_up(cdsm_vtk.vtkCdsmTransmittanceFilter())
        query.SetInputData(pipelines.square(1))
        query.AddInputData(2, pipelines.square(2))
        query.AddInputData(2, pipelines.square(0))
        query.SetMapSize(512)
        query.SetLightCutoff(60)
        for kind, side in itertools.product(("directional", "omni", "spot"), (1, -1)):  # from above, from below
            query.SetLightType(kind)
            query.SetLightPosition(0, 20 * side, 0)
            query.SetLightDirection(0, -side, 0)
            for bias in 0, 0.9, 1.8, 90:  # the last one only almost to where the light is
                query.SetBias(bias)
                query.Update()
                self.assertEqual(pipelines.values_of(query)[4], bias > 1, (kind, side, bias))

    def test_arrays_of_their_name_are_not_passed_on(self):
        second = cdsm_vtk.vtkCdsmShadowFilter()
        second.SetInputConnection(self.shadows.GetOutputPort())
        second.SetMapSize(0)
        pipelines.errors_of(second)
        second.Update()
        self.assertIsNotNone(pipelines.values_of(self.shadows))
        self.assertIsNone(pipelines.values_of(second))

    def test_the_whole_image_is_asked_for(self):
        source, shadows = vtkRTAnalyticSource(), cdsm_vtk.vtkCdsmShadowFilter()
        source.SetWholeExtent(0, 9, 0, 9, 0, 9)
        shadows.SetInputConnection(source.GetOutputPort())
        shadows.SetLightType("omni")
        shadows.SetLightPosition(4, 30, 4)
        shadows.GetVolumeProperty().SetScalarOpacityUnitDistance(20)
        shadows.UpdateExtent([2, 4, 2, 4, 2, 4])
        self.assertEqual(len(pipelines.values_of(shadows)), 1000)
        self.assertLess(pipelines.values_of(shadows).min(), 0.9)

    def test_nothing_changed_means_no_execution(self):
        self.shadows.Update()
        before = self.shadows.GetOutput().GetPointData().GetArray("Transmittance")
        self.shadows.Update()
        self.assertIs(self.shadows.GetOutput().GetPointData().GetArray("Transmittance"), before)

    def test_a_moved_light_uploads_no_voxel(self):
        self.expect_lowest()
        self.shadows.SetLightDirection(0, 1, 0)
        self.assertAlmostEqual(self.lowest(), 0.75 ** 0.125, delta=pipelines.NEAR)
        self.assertLess(self.shadows.GetStats()["uploaded_bytes"], self.image.GetNumberOfPoints() * 2)

    def test_changes_are_seen(self):
        self.expect_lowest()
        voxels = vtk_to_numpy(self.image.GetPointData().GetScalars())
        voxels[:] = 0
        self.image.Modified()
        self.assertEqual(self.lowest(), 1)
        self.assertEqual(self.shadows.GetStats()["copied_bytes"], 0)
        voxels[:] = 1
        self.image.GetPointData().GetScalars().Modified()
        self.expect_lowest()
        self.image.SetSpacing(0.5, 0.125, 0.5)
        self.expect_lowest()
        surface = pipelines.square(5)
        self.shadows.AddInputData(1, surface)
        self.shadows.SetSurfaceOpacity(0.5)
        self.expect_lowest(0.5)
        vtk_to_numpy(surface.GetPoints().GetData())[:] = 100
        surface.GetPoints().Modified()
        self.expect_lowest()

    def test_changes_of_opacities_are_seen(self):
        self.lowest()
        opacity = self.shadows.GetVolumeProperty().GetScalarOpacity()
        opacity.AddPoint(0, pipelines.OPACITY)
        opacity.AddPoint(1, 0)
        self.assertEqual(self.lowest(), 1)
        self.shadows.GetVolumeProperty().SetScalarOpacityUnitDistance(1)
        self.assertEqual(self.lowest(), 1)
        self.shadows.SetVolumeProperty(vtkVolumeProperty())  # VTK's own default is opaque
        self.assertLess(self.lowest(), 0.01)
        self.shadows.GetVolumeProperty().GetScalarOpacity().AddPoint(1, 0)
        self.assertEqual(self.lowest(), 1)
        self.shadows.SetScalarOpacity(None)
        self.shadows.AddOpacityPoint(1, 0)
        self.assertEqual(self.lowest(), 1)

    def test_progress_is_told_and_abort_ends_execution(self):
        told = []
        self.shadows.AddObserver("ProgressEvent", lambda shadows, _: told.append(shadows.GetProgress()))
        self.shadows.Update()
        self.assertGreater(len(told), 3)
        self.assertEqual((sorted(told), told[-1]), (told, 1))
        observer = self.shadows.AddObserver("ProgressEvent", lambda shadows, _: shadows.SetAbortExecute(1))
        self.image.Modified()
        self.shadows.Update()
        self.assertIsNone(pipelines.values_of(self.shadows))
        self.shadows.RemoveObserver(observer)
        self.shadows.SetAbortExecute(0)  # later versions of VTK leave it set
        self.image.Modified()
        self.expect_lowest()

    def test_filters_end_with_their_last_reference(self):
        self.shadows.Update()
        values = pipelines.values_of(self.shadows)
        before, known = values.copy(), weakref.ref(self.shadows)
        del self.shadows
        gc.collect()
        self.assertIsNone(known())
        np.testing.assert_array_equal(values, before)


if __name__ == "__main__":
    unittest.main()
