// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cdsm/vtk/vtkCdsmFilter.h>

/// The light at the points of any vtkDataSet: port 0 is asked about and casts nothing, port 1 a vtkImageData that
/// casts, port 2 any number of vtkPolyData that cast. Both may be left out.
class CDSM_API vtkCdsmTransmittanceFilter : public vtkCdsmFilter {
 public:
  static vtkCdsmTransmittanceFilter* New();
  vtkTypeMacro(vtkCdsmTransmittanceFilter, vtkCdsmFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// World units by which points are moved towards the light before they are asked about, at least 0. Points of a
  /// surface that casts itself need some. Default: 0.
  vtkSetMacro(Bias, double);
  vtkGetMacro(Bias, double);

 protected:
  vtkCdsmTransmittanceFilter();
  ~vtkCdsmTransmittanceFilter() override;
};
