# SPDX-License-Identifier: Apache-2.0
"""ParaView's plugin: the filters "Cdsm Shadow" and "Cdsm Transmittance".

LoadPlugin("cdsm_paraview.py"), with the folder of the modules cdsm and cdsm_vtk in PYTHONPATH. docs/vtk.md explains."""
import inspect

from cdsm_vtk import vtkCdsmShadowFilter, vtkCdsmTransmittanceFilter

if not hasattr(inspect, "getargspec"):  # ParaView 5.11 asks for it, Python 3.11 no longer has it
    inspect.getargspec = inspect.getfullargspec
from paraview.util.vtkAlgorithm import smproperty, smproxy  # noqa: E402

# What ParaView is to know: an input, a property.
_INPUT = """<InputProperty name="{name}" port_index="{port}" command="{command}" {more}>
  <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
  <DataTypeDomain name="input_type" composite_data_supported="0"><DataType value="{type}"/></DataTypeDomain>
  {domain}<Hints>{hints}</Hints><Documentation>{text}</Documentation></InputProperty>"""
_SCALARS = """<StringVectorProperty name="Scalars" command="SetScalars" number_of_elements="5"
    element_types="0 0 0 0 2">
  <ArrayListDomain name="array_list" attribute_type="Scalars" input_domain_name="scalars">
    <RequiredProperties><Property name="{input}" function="Input"/></RequiredProperties></ArrayListDomain>
  <Documentation>Of the image's points: float, signed or unsigned char or short.</Documentation>
</StringVectorProperty>"""
_VECTOR = """<{kind}VectorProperty name="{name}" command="Set{name}" number_of_elements="{count}"
  default_values="{default}">{domain}<Documentation>{text}</Documentation></{kind}VectorProperty>"""
_OPACITY = """<ProxyProperty name="ScalarOpacity" command="SetScalarOpacity">
  <ProxyGroupDomain name="groups"><Group name="piecewise_functions"/></ProxyGroupDomain>
  <Documentation>In scripts: GetOpacityTransferFunction('...'). Without one the OpacityPoints count.</Documentation>
</ProxyProperty>
<DoubleVectorProperty name="OpacityPoints" command="AddOpacityPoint" clean_command="ClearOpacityPoints"
    repeat_command="1" use_index="0" number_of_elements_per_command="2">
  <Documentation>Value and opacity per unit distance, linear in between.</Documentation>
  <Hints><ShowComponentLabels><ComponentLabel component="0" label="Value"/>
  <ComponentLabel component="1" label="Opacity"/></ShowComponentLabels></Hints></DoubleVectorProperty>"""
_LIGHT_TYPES = """<EnumerationDomain name="enum"><Entry text="Spot" value="0"/><Entry text="Omni" value="1"/>
  <Entry text="Directional" value="2"/></EnumerationDomain>"""
_PROPERTIES = [("Double", "ScalarOpacityUnitDistance", 1, "1", ""), ("Int", "LightType", 1, "0", _LIGHT_TYPES),
               ("Double", "LightPosition", 3, "0 1 0", ""), ("Double", "LightTarget", 3, "0 0 0", ""),
               ("Double", "LightDirection", 3, "0 -1 0", ""), ("Double", "LightCutoff", 1, "30", ""),
               ("Double", "SurfaceOpacity", 1, "1", ""), ("Int", "MapSize", 1, "512", ""),
               ("Double", "Tolerance", 1, "0.01", ""), ("String", "Technique", 1, "deep-shadow-map", ""),
               ("String", "ArrayName", 1, "Transmittance", ""), ("String", "Device", 1, "", "")]
_BIAS = ("Double", "Bias", 1, "0", "")


def _described(kind, properties):
    """The XML of a filter's properties; their documentation is that of its methods."""
    names = dict(zip(kind.TYPES, ("Input", "Image", "Surfaces") if kind.IMAGE else ("Input", "Surfaces")))
    parts = []
    for port, (data, name) in enumerate(names.items()):
        many = port == kind.SURFACES
        parts.append(_INPUT.format(
            name=name, port=port, type=data, text=kind.__doc__, hints="<Optional/>" if port else "",
            command="AddInputConnection" if many else "SetInputConnection",
            more='multiple_input="1" clean_command="ClearSurfaces"' if many else "",
            domain='<InputArrayDomain name="scalars" attribute_type="point" number_of_components="1"/>'
            if port == kind.IMAGE else ""))
    parts += [_SCALARS.format(input=names["vtkImageData"]), _OPACITY]
    for number, name, count, default, domain in properties:
        parts.append(_VECTOR.format(kind=number, name=name, count=count, default=default, domain=domain,
                                    text=getattr(kind, "Set" + name).__doc__ or name))
    return "\n".join(parts)


class _Offered:
    def __init__(self):
        super().__init__()
        self.SetScalarOpacity(None)  # OpacityPoints count until a function is given

    def SetScalars(self, _index, _port, _connection, association, name):
        """Of the image, whatever port ParaView thinks that it is at."""
        self.SetInputArrayToProcess(0, self.IMAGE, 0, int(association), name)


class CdsmShadow(_Offered, vtkCdsmShadowFilter):
    __doc__ = vtkCdsmShadowFilter.__doc__


class CdsmTransmittance(_Offered, vtkCdsmTransmittanceFilter):
    __doc__ = vtkCdsmTransmittanceFilter.__doc__


for _kind, _label, _more in (CdsmShadow, "Cdsm Shadow", []), (CdsmTransmittance, "Cdsm Transmittance", [_BIAS]):
    smproxy.filter(label=_label, support_reload=False)(smproperty.xml(_described(_kind, _PROPERTIES + _more))(_kind))
