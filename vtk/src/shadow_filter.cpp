// SPDX-License-Identifier: Apache-2.0
#include <cdsm/vtk/vtkCdsmShadowFilter.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkCdsmShadowFilter);

vtkCdsmShadowFilter::vtkCdsmShadowFilter() : vtkCdsmFilter(0, 1) {}

vtkCdsmShadowFilter::~vtkCdsmShadowFilter() = default;
