// SPDX-License-Identifier: Apache-2.0
// Objects of VTK as those of a cdsm::Scene, for programs that render or query with an Engine of their own.
#pragma once

#include <memory>

#include <cdsm/export.hpp>
#include <cdsm/scene.hpp>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;
class vtkVolumeProperty;

namespace cdsm::vtk {

/// Opacities, colours and unit distance of component 0. Nodes between which VTK is linear are taken as they are; where
/// a midpoint, a sharpness, a colour space or a logarithmic scale bends the curve, points are added until it is off by
/// at most 0.001, or are an 8192th of the way between two nodes apart. Colours are taken as linear ones. Beyond the
/// ends of a function whose Clamping is off lies 0. Throws Error for gradient opacity and functions of two dimensions.
CDSM_API TransferFunction transferFunction(vtkVolumeProperty* property);

/// The grid of an image with one of its arrays of points as voxels, which stay where they are and are kept by the
/// result; the transfer function is still to be set. Throws Error unless there is one component per point, float,
/// signed or unsigned char or short, side by side.
CDSM_API Volume volume(vtkImageData* image, vtkDataArray* scalars);

/// Polygons and strips as triangles, whose points stay where they are, kept by the result, if they are floats side by
/// side: then nobody may add any to that vtkPoints, or squeeze it, as long as the result is used. Lines and vertices
/// cast no shadow. Null if there is no triangle.
CDSM_API std::shared_ptr<const MeshData> meshData(vtkPolyData* surface);

}  // namespace cdsm::vtk
