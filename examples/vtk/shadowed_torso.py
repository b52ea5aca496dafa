#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A chest CT drawn by VTK, without and with shadows from cdsm: shadowed_torso.py PICTURE.png [HEIGHT_IN_PIXELS]

VTK's own mappers draw all of it; the filters only say how much light is where. PYTHONPATH names the folder of the
modules cdsm and cdsm_vtk. Without a display: xvfb-run -a python3 shadowed_torso.py PICTURE.png"""
import pathlib
import sys

import numpy as np
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, VTK draws with it
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOImage import vtkNrrdReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkVolume, vtkVolumeProperty, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper

import cdsm_vtk

DATA = pathlib.Path(__file__).resolve().parents[2] / "scenes/demo/data"
LAMP, AIM = (-380, -620, 620), (200, 200, 20)  # millimetres, z is up
AMBIENT = 0.3
SUPERSAMPLING = 2  # pixels that are averaged, per side


def read_torso():
    """The scan with every second voxel of a slice's rows and columns."""
    reader, shrunk = vtkNrrdReader(), vtkImageShrink3D()
    reader.SetFileName(str(DATA / "torso_ct_512x512x96_u8.nrrd"))
    shrunk.SetInputConnection(reader.GetOutputPort())
    shrunk.SetShrinkFactors(2, 2, 1)
    shrunk.Update()
    return shrunk.GetOutput()


def torso_property():
    """Values are (HU + 1000) / 12: flesh 75 to 95, bone from 110."""
    opacity, color, made = vtkPiecewiseFunction(), vtkColorTransferFunction(), vtkVolumeProperty()
    for value, alpha in (70, 0), (80, 0.005), (96, 0.008), (110, 0.04), (125, 0.5), (190, 0.9):
        opacity.AddPoint(value, alpha)
    for value, *rgb in (70, 0.9, 0.5, 0.4), (96, 0.75, 0.2, 0.15), (112, 0.9, 0.6, 0.4), (126, 1, 0.95, 0.85):
        color.AddRGBPoint(value, *rgb)
    made.SetScalarOpacity(opacity)
    made.SetScalarOpacityUnitDistance(1)
    made.SetColor(color)
    made.SetInterpolationTypeToLinear()
    made.ShadeOn()
    made.SetAmbient(0.35)
    made.SetDiffuse(0.9)
    made.SetSpecular(0.15)
    return made


def place_teapot():
    reader, moved, place = vtkOBJReader(), vtkTransformFilter(), vtkTransform()
    reader.SetFileName(str(DATA / "teapot.obj"))
    place.Translate(95, 20, -5)
    place.RotateZ(-20)
    place.RotateX(90)
    place.Scale(0.9, 0.9, 0.9)
    moved.SetInputConnection(reader.GetOutputPort())
    moved.SetTransform(place)
    moved.Update()
    return moved.GetOutput()


def make_floor():
    floor = vtkPlaneSource()
    floor.SetOrigin(-900, -700, -5)
    floor.SetPoint1(1500, -700, -5)
    floor.SetPoint2(-900, 1500, -5)
    floor.SetResolution(700, 700)
    floor.Update()
    return floor.GetOutput()


def light(shadows):
    """The lamp as the filters are told of it."""
    shadows.SetLightPosition(*LAMP)
    shadows.SetLightTarget(*AIM)
    shadows.SetLightCutoff(40)
    shadows.SetMapSize(1024)
    return shadows


def light_in(image, made, *surfaces):
    """The image with its array of transmittances."""
    shadows = light(cdsm_vtk.vtkCdsmShadowFilter())
    shadows.SetVolumeProperty(made)
    shadows.SetInputData(image)
    for surface in surfaces:
        shadows.AddInputData(1, surface)
    shadows.Update()
    return shadows.GetOutput()


def light_on(surface, image, made, *casters):
    """The surface with its array of transmittances."""
    query = light(cdsm_vtk.vtkCdsmTransmittanceFilter())
    query.SetVolumeProperty(made)
    query.SetBias(2)
    query.SetInputData(surface)
    query.SetInputData(1, image)
    for caster in casters:
        query.AddInputData(2, caster)
    query.Update()
    return query.GetOutput()


def light_of(dataset, lit):
    """What is left of its light at each point, ambient light included; all of it if not `lit`."""
    transmittance = vtk_to_numpy(dataset.GetPointData().GetArray("Transmittance"))
    return AMBIENT + (1 - AMBIENT) * (transmittance if lit else np.ones_like(transmittance))


def bytes_of(colors):
    return numpy_to_vtk(np.clip(255 * colors, 0, 255).astype(np.uint8), deep=True)


def torso_volume(image, made, lit):
    """Colours times light, and the scan's value as fourth component, which VTK looks the opacity up for."""
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    table = np.array([made.GetRGBTransferFunction().GetColor(value) for value in range(256)])
    shaded = np.concatenate([table[values] * light_of(image, lit)[:, None], values[:, None] / 255], axis=1)
    colors, own, mapper, drawn = vtkImageData(), vtkVolumeProperty(), vtkFixedPointVolumeRayCastMapper(), vtkVolume()
    colors.CopyStructure(image)
    colors.GetPointData().SetScalars(bytes_of(shaded))
    own.DeepCopy(made)
    own.IndependentComponentsOff()
    mapper.SetInputData(colors)
    mapper.SetSampleDistance(0.4)
    mapper.SetAutoAdjustSampleDistances(False)
    drawn.SetMapper(mapper)
    drawn.SetProperty(own)
    return drawn


def surface_actor(surface, color, lit, specular=0.0):
    drawn, mapper, shaded = vtkActor(), vtkPolyDataMapper(), surface.NewInstance()
    shaded.ShallowCopy(surface)
    shaded.GetPointData().SetScalars(bytes_of(light_of(surface, lit)[:, None] * np.array(color)))
    mapper.SetInputData(shaded)
    drawn.SetMapper(mapper)
    drawn.GetProperty().SetAmbient(0.3)
    drawn.GetProperty().SetDiffuse(0.8)
    drawn.GetProperty().SetSpecular(specular)
    drawn.GetProperty().SetSpecularPower(40)
    return drawn


def add_lamp(renderer):
    lamp = vtkLight()
    lamp.SetPositional(True)
    lamp.SetConeAngle(90)
    lamp.SetIntensity(1.15)
    lamp.SetPosition(*LAMP)
    lamp.SetFocalPoint(*AIM)
    renderer.AddLight(lamp)


def make_renderer(torso, teapot, floor, made, lit):
    renderer = vtkRenderer()
    renderer.SetBackground(0.32, 0.33, 0.36)
    renderer.AddVolume(torso_volume(torso, made, lit))
    renderer.AddActor(surface_actor(teapot, (0.1, 0.42, 0.62), lit, specular=0.4))
    renderer.AddActor(surface_actor(floor, (0.74, 0.72, 0.68), lit))
    add_lamp(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(120, -780, 620)
    camera.SetFocalPoint(224, 165, 20)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(22)
    renderer.ResetCameraClippingRange()
    return renderer


def save(window, path):
    picture, smooth, writer = vtkWindowToImageFilter(), vtkImageShrink3D(), vtkPNGWriter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    smooth.SetInputConnection(picture.GetOutputPort())
    smooth.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
    writer.SetInputConnection(smooth.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main():
    path, height = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 440
    made, scan, pot = torso_property(), read_torso(), place_teapot()
    torso = light_in(scan, made, pot)
    floor, teapot = light_on(make_floor(), scan, made, pot), light_on(pot, scan, made, pot)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(2 * height * SUPERSAMPLING, height * SUPERSAMPLING)
    for half, lit in enumerate((False, True)):
        renderer = make_renderer(torso, teapot, floor, made, lit)
        renderer.SetViewport(half / 2, 0, (half + 1) / 2, 1)
        window.AddRenderer(renderer)
    window.Render()
    save(window, path)
    darkest = min(vtk_to_numpy(part.GetPointData().GetArray("Transmittance")).min() for part in (torso, teapot, floor))
    return 0 if darkest < 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
