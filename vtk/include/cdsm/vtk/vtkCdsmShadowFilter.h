// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cdsm/vtk/vtkCdsmFilter.h>

/// The light at the points of an image: port 0 is the vtkImageData, which casts shadows on itself, port 1 any number of
/// vtkPolyData that cast, too.
class CDSM_API vtkCdsmShadowFilter : public vtkCdsmFilter {
 public:
  static vtkCdsmShadowFilter* New();
  vtkTypeMacro(vtkCdsmShadowFilter, vtkCdsmFilter);

 protected:
  vtkCdsmShadowFilter();
  ~vtkCdsmShadowFilter() override;
};
