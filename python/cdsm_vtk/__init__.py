# SPDX-License-Identifier: Apache-2.0
"""Shadows in VTK: filters for pipelines, objects of VTK for scenes of cdsm. docs/vtk.md explains."""
from cdsm_vtk.convert import mesh, transfer_function, volume
from cdsm_vtk.filters import vtkCdsmShadowFilter, vtkCdsmTransmittanceFilter

__all__ = ["mesh", "transfer_function", "volume", "vtkCdsmShadowFilter", "vtkCdsmTransmittanceFilter"]
