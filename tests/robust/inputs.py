# SPDX-License-Identifier: Apache-2.0
"""Small inputs for the robustness cases, as bytes: meshes, volumes, points."""
import struct

CLOSED_OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
OPEN_OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
INDEX_OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"
NAN_OBJ = b"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
POINTS_CSV = b"x,y,z\n0.5,0.5,0.5\n-3,0,0\n"


def nrrd(voxels, kind="uint8", sizes="4 4 4", extra=""):
    """An NRRD with raw voxels."""
    header = f"NRRD0004\ntype: {kind}\ndimension: 3\nsizes: {sizes}\nencoding: raw\nendian: little\n{extra}\n"
    return header.encode() + voxels


GRID_NRRD = nrrd(bytes(range(64)))
NAN_NRRD = nrrd(struct.pack("<64f", *([0.5] * 63 + [float("nan")])), "float")
EMPTY_NRRD = nrrd(b"", sizes="0 4 4")
HUGE_NRRD = nrrd(bytes(64), sizes="100000 100000 100000")
FLAT_NRRD = nrrd(bytes(64), extra="space dimension: 3\nspace directions: (1,0,0) (2,0,0) (0,0,1)\n")


def stl(triangles, claimed=None):
    """A binary STL of unit triangles; `claimed`: the number that the header claims."""
    one = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    return bytes(80) + struct.pack("<I", triangles if claimed is None else claimed) + one * triangles


def ply(vertices_claimed):
    """An ASCII PLY with three vertices and one triangle."""
    header = f"ply\nformat ascii 1.0\nelement vertex {vertices_claimed}\nproperty float x\nproperty float y\n"
    header += "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    return header.encode() + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


def vti(extent, data, components=1, section="PointData"):
    """VTK image data with UInt8 voxels as text."""
    return (f'<VTKFile type="ImageData" version="1.0"><ImageData WholeExtent="{extent}"><Piece Extent="{extent}">\n'
            f'<{section}><DataArray type="UInt8" Name="a" NumberOfComponents="{components}" format="ascii">{data}\n'
            f"</DataArray></{section}></Piece></ImageData></VTKFile>\n").encode()


ATOMS_XYZ = b"2\n\nN 0 0 0\nC 1.0 2 3\n"


def pdb(element):
    """An entry with one atom of water."""
    atom = "HETATM    1  O   HOH A   1       1.000   2.000   3.000  1.00  0.00         " + element
    return f"HEADER    TEST\n{atom}\nEND\n".encode()


def mmcif(x):
    """An entry with two atoms, one a line."""
    tags = "".join(f"_atom_site.{tag}\n" for tag in ("type_symbol", "Cartn_x", "Cartn_y", "Cartn_z"))
    return f"data_TEST\nloop_\n{tags}N 0 0 0\nC {x} 2 3.25\n".encode()


GRID_VTI = vti("0 3 0 3 0 3", " ".join(map(str, range(64))))
PRESET = b'{"ColorSpace": "Lab", "RGBPoints": [0, 0, 0, 1, 63, 1, 0, 0], "Points": [0, 0, 0.5, 0, 63, 0.5, 0.5, 0]}'
