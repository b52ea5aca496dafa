// SPDX-License-Identifier: Apache-2.0
#include <cdsm/vtk/vtkCdsmTransmittanceFilter.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkCdsmTransmittanceFilter);

vtkCdsmTransmittanceFilter::vtkCdsmTransmittanceFilter() : vtkCdsmFilter(1, 2) {}

vtkCdsmTransmittanceFilter::~vtkCdsmTransmittanceFilter() = default;

void vtkCdsmTransmittanceFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bias: " << this->Bias << "\n";
}
