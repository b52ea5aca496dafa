# SPDX-License-Identifier: Apache-2.0
"""Pipelines of ParaView with the plugin, run by pvpython with the folder of the modules in PYTHONPATH."""
import sys
import unittest

import cdsm_paraview  # mends what ParaView 5.11 lacks with Python 3.11
from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger

LOW, HIGH = 30, 280  # of the wavelet's values
OPACITY = 0.1        # per 1, of HIGH


class Plugin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(cdsm_paraview.__file__, ns=vars(simple))

    def setUp(self):
        self.wavelet = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
        self.shadows = simple.CdsmShadow(Input=self.wavelet, Scalars=["POINTS", "RTData"], LightType="Directional",
                                         OpacityPoints=[LOW, 0, HIGH, OPACITY])

    def darkest(self, proxy=None):
        proxy = proxy or self.shadows
        proxy.UpdatePipeline()
        return proxy.PointData["Transmittance"].GetRange()[0]

    def test_opacities_come_from_points_or_from_a_function(self):
        by_points = self.darkest()
        self.assertTrue(0.9 ** 17 < by_points < 0.5)
        opacity = simple.GetOpacityTransferFunction("RTData")
        opacity.Points = [LOW, 0, 0.5, 0, HIGH, OPACITY, 0.5, 0]
        self.shadows.OpacityPoints = []
        self.shadows.ScalarOpacity = opacity
        self.assertEqual(self.darkest(), by_points)
        opacity.Points = [LOW, 0, 0.5, 0, HIGH, 2 * OPACITY, 0.5, 0]
        self.assertLess(self.darkest(), 0.7 * by_points)
        self.shadows.ScalarOpacityUnitDistance = 100
        self.assertGreater(self.darkest(), by_points)

    def test_the_array_is_chosen_as_in_other_filters(self):
        opacity = [LOW, 0, HIGH, OPACITY]
        early = simple.CdsmShadow(Input=simple.Wavelet(), LightType="Directional", OpacityPoints=opacity)
        self.assertLess(self.darkest(early), 0.5)  # the active one
        self.wavelet.UpdatePipeline()
        query = simple.CdsmTransmittance(Input=simple.Plane(), Image=self.wavelet)
        for proxy in simple.CdsmShadow(Input=self.wavelet), query:
            self.assertEqual(list(proxy.Scalars), ["POINTS", "RTData"])
        query.OpacityPoints, query.LightType = opacity, "Directional"
        self.assertLess(self.darkest(query), 0.9)

    def test_surfaces_come_and_go(self):
        alone = self.darkest()
        spheres = [simple.Sphere(Center=[0, 20, 0], Radius=radius) for radius in (4, 6)]
        self.shadows.Surfaces = spheres
        self.shadows.SurfaceOpacity = 0.5
        self.assertLess(self.darkest(), 0.1 * alone)  # four crossings
        self.shadows.Surfaces = []
        self.assertEqual(self.darkest(), alone)

    def test_other_points_are_asked_about(self):
        floor = simple.Plane(Origin=[-9, -15, -9], Point1=[9, -15, -9], Point2=[-9, -15, 9], XResolution=20,
                             YResolution=20)
        query = simple.CdsmTransmittance(Input=floor, Image=self.wavelet, Scalars=["POINTS", "RTData"],
                                         OpacityPoints=[LOW, 0, HIGH, OPACITY], LightType="Directional")
        self.assertLess(self.darkest(query), 0.5)
        self.assertEqual(query.PointData["Transmittance"].GetRange()[1], 1)
        self.assertEqual(query.GetDataInformation().GetDataSetTypeAsString(), "vtkPolyData")
        surfaces = simple.CdsmTransmittance(Input=floor, Surfaces=simple.Sphere(Radius=6), LightType="Directional")
        self.assertEqual(self.darkest(surfaces), 0)

    def test_wrong_settings_leave_no_array_and_the_filter_usable(self):
        darkest = self.darkest()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        for name, wrong in ("MapSize", 1), ("Technique", "magic"), ("LightCutoff", 90), ("OpacityPoints", []):
            right = getattr(self.shadows, name)
            right = right if isinstance(right, (int, float, str)) else list(right)
            if name == "LightCutoff":
                self.shadows.LightType = "Spot"
            setattr(self.shadows, name, wrong)
            self.shadows.UpdatePipeline()
            self.assertIsNone(self.shadows.PointData["Transmittance"], name)
            setattr(self.shadows, name, right)
            self.shadows.LightType = "Directional"
            self.assertEqual(self.darkest(), darkest, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
