# SPDX-License-Identifier: Apache-2.0
"""ParaView with the plugin of cdsm: pvpython paraview_wavelet.py [PICTURE.png]

A floor and an isosurface in the light that is left behind a volume. PYTHONPATH names the folder of the modules cdsm,
cdsm_vtk and cdsm_paraview. A picture needs a display, or xvfb-run -a."""
import sys

import cdsm_paraview  # first: ParaView 5.11 loads no plugin in Python 3.11 without
from paraview.simple import *

LoadPlugin(cdsm_paraview.__file__, ns=globals())

wavelet = Wavelet()
opacity = GetOpacityTransferFunction("RTData")
opacity.Points = [100, 0, 0.5, 0, 277, 0.5, 0.5, 0]
light = {"LightPosition": [-30, 60, 30], "ScalarOpacity": opacity, "ScalarOpacityUnitDistance": 2,
         "LightCutoff": 40}

shadows = CdsmShadow(Input=wavelet, Scalars=["POINTS", "RTData"], **light)
surface = Contour(Input=shadows, ContourBy=["POINTS", "RTData"], Isosurfaces=[160])
floor = Plane(Origin=[-25, -12, 25], Point1=[25, -12, 25], Point2=[-25, -12, -25], XResolution=200, YResolution=200)
on_floor = CdsmTransmittance(Input=floor, Image=wavelet, Scalars=["POINTS", "RTData"], **light)

darkest = []
for part in surface, on_floor:
    part.UpdatePipeline()
    darkest.append(part.PointData["Transmittance"].GetRange()[0])
    ColorBy(Show(part), ("POINTS", "Transmittance"))
print("darkest on the surface %.3f, on the floor %.3f" % tuple(darkest))
if len(sys.argv) > 1:
    GetColorTransferFunction("Transmittance").ApplyPreset("Grayscale", True)
    view = GetActiveViewOrCreate("RenderView")
    ResetCamera(view)
    GetActiveCamera().Elevation(30)
    SaveScreenshot(sys.argv[1], view, ImageResolution=[720, 480])
Disconnect()  # views end before Python does
sys.exit(0 if max(darkest) < 0.1 else 1)
