# SPDX-License-Identifier: Apache-2.0
"""Filters that add what of a light gets to the points of data sets; those of C++ have the same names and methods."""
import weakref

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkObject, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkDataSetAttributes, vtkPiecewiseFunction
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

import cdsm
from cdsm_vtk.convert import mesh, require, transfer_function, volume
from cdsm_vtk.points import moved, points_between

BATCH = 1 << 20  # points asked about at once
BUILT = 0.4      # progress by which the maps are there
LIGHT = "light"


class _Aborted(Exception):
    """Somebody set AbortExecute."""


class _Filter(VTKPythonAlgorithmBase):
    """What both filters share: a light, what casts shadows, and an engine that is kept, so that only what has changed
    is built again. Errors are told as VTK's own are (ErrorEvent); the array is then missing, and the filter can be used
    on."""

    TYPES = ("vtkDataSet",)  # of the ports
    IMAGE, SURFACES = 0, 1   # ports of what casts

    def __init__(self):
        super().__init__(nInputPorts=len(self.TYPES), outputType="vtkDataSet")
        self._light = cdsm.Light(name=LIGHT, target=(0, 0, 0))
        self._bias = 0.0
        self._surface_opacity = 1.0
        self._array_name = "Transmittance"
        self._device = ""
        self._shadows = cdsm.ShadowSettings()
        self._points = vtkPiecewiseFunction()  # of AddOpacityPoint()
        self._watched = []
        self._stats = {}
        self.Drop()
        self.SetVolumeProperty(vtkVolumeProperty())
        self.SetInputArrayToProcess(0, self.IMAGE, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS,
                                    vtkDataSetAttributes.SCALARS)

    def SetInputData(self, *port_and_data):
        """Of port 0 if none is given, as AddInputData()."""
        self.SetInputDataObject(*port_and_data)

    def AddInputData(self, *port_and_data):
        self.AddInputDataObject(*port_and_data)

    def GetOutput(self):
        return self.GetOutputDataObject(0)

    def _set(self, name, value):
        setattr(self, name, value)
        self.Modified()

    def _set_of(self, part, name, value):
        setattr(part, name, value)
        self.Modified()

    def SetLightType(self, kind):
        """0 or 'spot', 1 or 'omni', 2 or 'directional'. Default: 'spot'."""
        kinds = ("spot", "omni", "directional")
        self._set_of(self._light, "type", kinds[kind] if kind in (0, 1, 2) else kind)

    def SetLightPosition(self, x, y, z):
        """Of spot and omni lights. Default: (0, 1, 0)."""
        self._set_of(self._light, "position", (x, y, z))

    def SetLightTarget(self, x, y, z):
        """A point that a spot light shines at. Default: (0, 0, 0)."""
        self._set_of(self._light, "target", (x, y, z))

    def SetLightDirection(self, x, y, z):
        """The way in which directional light travels. Default: (0, -1, 0)."""
        self._set_of(self._light, "direction", (x, y, z))

    def SetLightCutoff(self, degrees):
        """Half the angle of a spot light's cone, in (0, 90). Default: 30."""
        self._set_of(self._light, "cutoff", degrees)

    def SetVolumeProperty(self, volume_property):
        """Opacities and unit distance of the image's component 0. There is one from the beginning."""
        require(volume_property, vtkVolumeProperty, "the volume property is")
        self._set("_property", volume_property)
        self._watch()

    def GetVolumeProperty(self):
        return self._property

    def SetScalarOpacity(self, function):
        """Opacities of the volume property: a vtkPiecewiseFunction. None: those of AddOpacityPoint()."""
        self._property.SetScalarOpacity(function or self._points)

    def SetScalarOpacityUnitDistance(self, length):
        """World length for which the opacities hold. Default: 1."""
        self._property.SetScalarOpacityUnitDistance(length)

    def AddOpacityPoint(self, value, opacity):
        self._points.AddPoint(value, opacity)

    def ClearOpacityPoints(self):
        self._points.RemoveAllPoints()

    def SetSurfaceOpacity(self, opacity):
        """Of one crossing of the surfaces, in [0, 1]. Default: 1."""
        require(opacity, (float, int), "the opacity is")
        self._set("_surface_opacity", opacity)

    def ClearSurfaces(self):
        self.RemoveAllInputConnections(self.SURFACES)

    def SetShadows(self, shadows):
        """Technique, size of maps, tolerance and the like, a cdsm.ShadowSettings; those below are of them."""
        require(shadows, cdsm.ShadowSettings, "shadows is")
        self._set("_shadows", shadows)

    def GetShadows(self):
        return self._shadows

    def SetTechnique(self, technique):
        self._set_of(self._shadows, "technique", technique)

    def SetMapSize(self, texels):
        self._set_of(self._shadows, "map_size", texels)

    def SetTolerance(self, tolerance):
        self._set_of(self._shadows, "tolerance", tolerance)

    def SetArrayName(self, name):
        """Of the array that is added. Default: Transmittance."""
        require(name, str, "the array name is")
        self._set("_array_name", name)

    def SetDevice(self, device):
        """OpenCL device: 'platform:device' or part of a name. Default: CDSM_DEVICE, else the first usable."""
        device = "" if device is None else device  # as ParaView says ""
        require(device, str, "the device is")
        if device != self._device:
            self.Drop()
        self._set("_device", device)

    def GetStats(self):
        """cdsm.Engine.stats of what the last execution built."""
        return self._stats

    def Drop(self):
        """Lets go of the engine, with what it has built and the arrays that it keeps."""
        self._engine, self._volume, self._scalars, self._image_time, self._meshes = None, None, None, 0, {}

    def _watch(self, *_):
        """Executes again when the volume property or a function of it changes: VTK asks no filter in Python for the
        time of its modification."""
        for thing, tag in self._watched:
            thing.RemoveObserver(tag)
        this = weakref.ref(self)
        self.Modified()
        things = [self._property, self._property.GetScalarOpacity()]
        changed = [lambda *_: this() and this()._watch(), lambda *_: this() and this().Modified()]
        self._watched = [(thing, thing.AddObserver("ModifiedEvent", act)) for thing, act in zip(things, changed)]

    def _use_engine(self):
        if self._engine is None:
            this = weakref.ref(self)
            done = {"upload": 0.0, "shadows": 0.1}
            self._engine = cdsm.Engine(device=self._device, warning=lambda text: this()._tell("Warning", text),
                                       progress=lambda step, _: step in done and this()._progress(done[step]))
        return self._engine

    def _progress(self, done):
        self.UpdateProgress(done)
        if self.GetAbortExecute():
            raise _Aborted()

    def _tell(self, kind, text):
        """As vtkErrorMacro and vtkWarningMacro do."""
        if self.HasObserver(kind + "Event"):
            self.InvokeEvent(kind + "Event", text)
        elif vtkObject.GetGlobalWarningDisplay():
            window = vtkOutputWindow.GetInstance()
            (window.DisplayErrorText if kind == "Error" else window.DisplayWarningText)(
                f"{kind}: {type(self).__name__}: {text}\n")

    def _scalars_of(self, image):
        wanted = self.GetInputArrayInformation(0)
        name, kind = wanted.Get(vtkDataObject.FIELD_NAME()), wanted.Get(vtkDataObject.FIELD_ATTRIBUTE_TYPE())
        points = image.GetPointData()
        scalars = points.GetArray(name) if name else points.GetAttribute(kind)
        if wanted.Get(vtkDataObject.FIELD_ASSOCIATION()) == vtkDataObject.FIELD_ASSOCIATION_CELLS:
            raise cdsm.Error("the image's array is of its cells, must be of its points; "
                             "vtkCellDataToPointData makes one")
        if scalars is None and image.GetCellData().GetNumberOfArrays():
            raise cdsm.Error("the image has no scalars of its points, only of its cells; "
                             "vtkCellDataToPointData makes some")
        if scalars is None:
            raise cdsm.Error("the image has no scalars of its points, or not those of SetInputArrayToProcess()")
        return scalars

    def _volume_of(self, image):
        """The same object as before with another revision, if the array is the same."""
        scalars = self._scalars_of(image)
        new = volume(image, scalars)
        place = (lambda v: (v.voxels.__array_interface__["data"], v.voxels.dtype, v.voxels.shape))
        if scalars is self._scalars and place(new) == place(self._volume):
            self._volume.world_from_object = new.world_from_object
            self._volume.revision += image.GetMTime() != self._image_time
        else:
            self._volume, self._scalars = new, scalars
        self._image_time = image.GetMTime()
        self._volume.transfer = transfer_function(self._property)
        return self._volume

    def _meshes_of(self, surfaces):
        def key(surface):  # points move without a new time when room for them is made or given back
            points = surface.GetPoints()
            return surface.GetMTime(), points and points.GetNumberOfPoints() and points.GetVoidPointer(0)

        made = [self._meshes.get(key(s)) or mesh(s) for s in surfaces]
        self._meshes = {key(s): m for s, m in zip(surfaces, made)}  # triangulating may move points
        meshes = [m for m in made if m]
        for number, each in enumerate(meshes):
            each.name, each.material = f"surface {number}", cdsm.Material(opacity=self._surface_opacity)
        return meshes

    def _make_scene(self, inInfo):
        def inputs(port):
            count = inInfo[port].GetNumberOfInformationObjects()
            return [data for data in (self.GetInputData(inInfo, port, i) for i in range(count)) if data]
        return cdsm.Scene(lights=[self._light], shadows=self._shadows,
                          volumes=[self._volume_of(image) for image in inputs(self.IMAGE)],
                          meshes=self._meshes_of(inputs(self.SURFACES)))

    def _transmittances(self, inInfo, dataset):
        if not self._bias >= 0:
            raise cdsm.Error(f"Bias is {self._bias}, must be at least 0")
        if self._shadows.transmittance != "grey":
            raise cdsm.Error(f"transmittance is {self._shadows.transmittance!r}, must be 'grey': one value for each "
                             "point")
        engine = self._use_engine()
        engine.prepare(self._make_scene(inInfo))
        self._stats = engine.stats
        count = dataset.GetNumberOfPoints()
        array = vtkFloatArray()
        array.SetName(self._array_name)
        array.SetNumberOfTuples(count)
        values = vtk_to_numpy(array) if count else None
        for first in range(0, count, BATCH):
            self._progress(BUILT + (1 - BUILT) * first / count)
            points = points_between(dataset, first, min(first + BATCH, count))
            if self._bias:
                points = moved(points, self._light, self._bias)
            batch = values[first:first + BATCH]
            engine.transmittance(LIGHT, np.ascontiguousarray(points, np.float32), out=batch)
            np.maximum(batch, 0, out=batch)  # -1 outside of the cone
        return array

    def FillInputPortInformation(self, port, info):
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), self.TYPES[port])
        if port > 0:
            info.Set(self.INPUT_IS_OPTIONAL(), 1)
        if port == self.SURFACES:
            info.Set(self.INPUT_IS_REPEATABLE(), 1)
        return 1

    def RequestDataObject(self, request, inInfo, outInfo):
        given, made = self.GetInputData(inInfo, 0, 0), vtkDataSet.GetData(outInfo)
        if given and (made is None or made.GetClassName() != given.GetClassName()):
            outInfo.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), given.NewInstance())
        return 1

    def RequestUpdateExtent(self, request, inInfo, outInfo):
        for vector in inInfo[self.IMAGE], inInfo[self.SURFACES]:  # all that casts, whatever part is asked for
            for info in map(vector.GetInformationObject, range(vector.GetNumberOfInformationObjects())):
                info.Set(Pipeline.UPDATE_PIECE_NUMBER(), 0)
                info.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), 1)
                info.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
                if info.Has(Pipeline.WHOLE_EXTENT()):
                    info.Set(Pipeline.UPDATE_EXTENT(), info.Get(Pipeline.WHOLE_EXTENT()), 6)
        return 1

    def RequestData(self, request, inInfo, outInfo):
        output = vtkDataSet.GetData(outInfo)
        output.ShallowCopy(self.GetInputData(inInfo, 0, 0))
        output.GetPointData().RemoveArray(self._array_name)  # one of that name is not ours
        try:
            output.GetPointData().AddArray(self._transmittances(inInfo, output))
        except _Aborted:
            return 1  # as VTK's own filters do
        except (cdsm.Error, TypeError, ValueError, MemoryError) as error:
            self._tell("Error", str(error))
            return 0
        return 1


class vtkCdsmShadowFilter(_Filter):
    """The light at the points of an image: port 0 is the vtkImageData, which casts shadows on itself, port 1 any number
    of vtkPolyData that cast, too."""

    TYPES = ("vtkImageData", "vtkPolyData")
    IMAGE, SURFACES = 0, 1


class vtkCdsmTransmittanceFilter(_Filter):
    """The light at the points of any vtkDataSet: port 0 is asked about and casts nothing, port 1 a vtkImageData that
    casts, port 2 any number of vtkPolyData that cast. Both may be left out."""

    TYPES = ("vtkDataSet", "vtkImageData", "vtkPolyData")
    IMAGE, SURFACES = 1, 2

    def SetBias(self, length):
        """World units by which points are moved towards the light before they are asked about, at least 0. Points of a
        surface that casts itself need some. Default: 0."""
        require(length, (float, int), "Bias is")
        self._set("_bias", length)
