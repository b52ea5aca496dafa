#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the small inputs of the io tests beside itself. Same script, same bytes.

Grids: 3 x 2 x 4 voxels, voxel (x, y, z) holds x + 10 y + 100 z unless said otherwise, x fastest.
Meshes: the cube [0, 1]^3, closed, 8 corners, 12 triangles, seen from outside counter-clockwise.
"""
import base64
import gzip
import json
import os
import struct
import zlib

FOLDER = os.path.dirname(os.path.abspath(__file__))
SIZE = (3, 2, 4)
GRID = [x + 10 * y + 100 * z for z in range(4) for y in range(2) for x in range(3)]
SMALL = [x + 10 * y + 60 * z for z in range(4) for y in range(2) for x in range(3)]  # fits 8 bits
SIGNED = [value - 150 for value in GRID]


def write(name, data):
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(data.encode() if isinstance(data, str) else data)


def pack(code, values):
    """Code as of struct, with the byte order first: '<h'."""
    return struct.pack(code[0] + str(len(values)) + code[1], *values)


def zipped(data):
    return gzip.compress(data, mtime=0)


# --- NRRD ---
def nrrd(kind, encoding, lines):
    head = ["NRRD0004", "type: " + kind, "dimension: 3", "sizes: 3 2 4", "encoding: " + encoding]
    return "\n".join(head + lines) + "\n"


SPACE = ["space: left-posterior-superior", "space directions: (0.5,0,0) (0,0,1) (0,-2,0)", "space origin: (10,20,30)"]
write("raw_u8.nrrd", nrrd("uchar", "raw", SPACE).encode() + b"\n" + pack("<B", SMALL))
write("gzip_i16_big.nrrd", nrrd("short", "gzip", ["endian: big", "spacings: 0.5 nan 2"]).encode() + b"\n"
      + zipped(pack(">h", SIGNED)))
write("detached_f32.nhdr", nrrd("float", "raw", ["endian: little", "byte skip: 4", "data file: detached_f32.raw"]))
write("detached_f32.raw", b"skip" + pack("<f", [value / 4 for value in GRID]))
write("ascii_u16.nrrd", nrrd("ushort", "ascii", []) + "\n" + " ".join(map(str, GRID)) + "\n")
write("list_axis_u8.nrrd", "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 1 3 2 4\nencoding: raw\nspace dimension: 3\n"
      "space directions: none (1,0,0) (0,1,0) (0,0,1)\n\n".encode() + pack("<B", SMALL))


# --- MetaImage ---
def metaimage(kind, data_file, lines):
    head = ["ObjectType = Image", "NDims = 3", "DimSize = 3 2 4", "ElementType = " + kind]
    return ("\n".join(head + lines + ["ElementDataFile = " + data_file]) + "\n").encode()


PLACE = ["TransformMatrix = 0 1 0 -1 0 0 0 0 1", "Offset = 10 20 30", "ElementSpacing = 0.5 1 2"]
write("local_u8.mha", metaimage("MET_UCHAR", "LOCAL", PLACE) + pack("<B", SMALL))
write("beside_i16_big.mhd", metaimage("MET_SHORT", "beside_i16_big.raw",
                                        ["ElementByteOrderMSB = True", "HeaderSize = -1"]))
write("beside_i16_big.raw", b"some header" + pack(">h", SIGNED))
write("beside_zlib_f32.mhd", metaimage("MET_FLOAT", "beside_zlib_f32.zraw", ["CompressedData = True"]))
write("beside_zlib_f32.zraw", zlib.compress(pack("<f", [value / 4 for value in GRID])))
write("local_zlib_u16.mha", metaimage("MET_USHORT", "LOCAL", ["CompressedData = True"])
      + zlib.compress(pack("<H", GRID)))
write("local_i8.mha", metaimage("MET_CHAR", "LOCAL", []) + pack("<b", [value - 128 for value in SMALL]))
write("local_i32.mha", metaimage("MET_INT", "LOCAL", []) + pack("<i", [value << 20 for value in SIGNED]))
write("local_f64.mha", metaimage("MET_DOUBLE", "LOCAL", []) + pack("<d", [value / 10 for value in GRID]))


# --- NIfTI-1 ---
def nifti(order, code, bits, offset, magic, qform=0, sform=0, dim=(3, 3, 2, 4, 1, 1, 1, 1), slope=7.0):
    """scl_slope is 7 to see that it is not applied."""
    head = struct.pack(order + "i10s18sihcB", 348, b"", b"", 0, 0, b"r", 0)
    head += struct.pack(order + "8h3fhhhh8f", *dim, 0, 0, 0, 0, code, bits, 0, 1, 0.5, 1, 2, 0, 0, 0, 0)
    head += struct.pack(order + "fffhBBffffii", offset, slope, 3.0, 0, 0, 2, 0, 0, 0, 0, 0, 0)
    head += struct.pack(order + "80s24shh6f", b"", b"", qform, sform, 0, 0, 0, 10, 20, 30)
    rows = ([0, -1, 0, 10], [0.5, 0, 0, 20], [0, 0, 2, 30])
    head += struct.pack(order + "12f16s4s", *rows[0], *rows[1], *rows[2], b"", magic)
    return head


write("pixdim_u8.nii", nifti("<", 2, 8, 352, b"n+1\0") + bytes(4) + pack("<B", SMALL))
write("sform_i16.nii.gz", zipped(nifti("<", 4, 16, 352, b"n+1\0", qform=1, sform=1) + bytes(4) + pack("<h", SIGNED)))
write("qform_f32_big.hdr", nifti(">", 16, 32, 0, b"ni1\0", qform=1))
write("qform_f32_big.img", pack(">f", [value / 4 for value in GRID]))
write("time_u8.nii", nifti("<", 2, 8, 352, b"n+1\0", dim=(4, 3, 2, 4, 2, 1, 1, 1)) + bytes(4)
      + pack("<B", SMALL + SMALL))


# --- raw voxels, named by size and type ---
write("grid_3x2x4_uint8.raw", pack("<B", SMALL))
write("grid_3x2x4_int16.raw.gz", zipped(pack("<h", SIGNED)))


# --- VTK image data ---
def vti(array, data="", attributes="", image='Origin="10 20 30" Spacing="0.5 1 2"', names='Scalars="grid"'):
    return (f'<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" {attributes}>\n'
            f'  <ImageData WholeExtent="0 2 0 1 0 3" {image}>\n    <Piece Extent="0 2 0 1 0 3">\n'
            f"      <PointData {names}>\n        {array}\n      </PointData>\n      <CellData/>\n    </Piece>\n"
            f"  </ImageData>\n{data}</VTKFile>\n")


def data_array(kind, form, content="", more=""):
    return f'<DataArray type="{kind}" Name="grid" format="{form}" {more}>{content}</DataArray>'


def counted(code, data):
    """VTK's plain data: their number of bytes first."""
    return struct.pack(code, len(data)) + data


def blocks(code, data, size):
    """VTK's compressed data: number of blocks, size, size of the last one if smaller, packed sizes; then the blocks."""
    parts = [zlib.compress(data[at:at + size]) for at in range(0, len(data), size)]
    numbers = [len(parts), size, len(data) % size] + [len(part) for part in parts]
    return b"".join(struct.pack(code, number) for number in numbers), b"".join(parts)


def text64(*pieces):
    return "".join(base64.b64encode(piece).decode() for piece in pieces)


ZLIB = 'compressor="vtkZLibDataCompressor"'
SKEW = 'Origin="10 20 30" Spacing="0.5 1 2" Direction="0 -1 0 1 0 0 0 0 1"'
write("ascii_u16.vti", vti(data_array("UInt16", "ascii", "\n" + " ".join(map(str, GRID)) + "\n"), image=""))
write("inline_i16_big.vti", vti(data_array("Int16", "binary",
                                           "\n  " + text64(counted(">I", pack(">h", SIGNED))) + "\n"),
                                attributes='byte_order="BigEndian"', image=SKEW))
write("inline_zlib_f64.vti", vti(data_array("Float64", "binary", text64(
    *blocks("<Q", pack("<d", [value / 10 for value in GRID]), 64))),
    attributes=f'header_type="UInt64" {ZLIB}', names=""))
write("appended_f32.vti", vti(
    data_array("UInt8", "appended", more='offset="0"').replace('"grid"', '"other"') + data_array(
        "Float32", "appended", more='offset="28"'), '  <AppendedData encoding="raw">\n   _@DATA@\n  </AppendedData>\n',
    'header_type="UInt32" byte_order="LittleEndian"').encode().replace(
        b"@DATA@", counted("<I", pack("<B", SMALL)) + counted("<I", pack("<f", [value / 4 for value in GRID]))))
write("appended_zlib_u8.vti", vti(
    data_array("UInt8", "appended", more='offset="0"'), '  <AppendedData encoding="base64">\n   _'
    + text64(*blocks(">I", pack(">B", SMALL), 10)) + "\n  </AppendedData>\n", f'byte_order="BigEndian" {ZLIB}'))


# --- DICOM: a CT of four slices, the first by position last by name; 150 is taken off each value ---
def element(group, number, kind, value):
    value = value.encode() if isinstance(value, str) else value
    value += (b"\0" if kind in ("UI", "OW") else b" ") * (len(value) % 2)
    size = struct.pack("<HI", 0, len(value)) if kind == "OW" else struct.pack("<H", len(value))
    return struct.pack("<HH2s", group, number, kind.encode()) + size + value


def dicom(z):
    instance = f"1.2.3.4.{z + 1}"
    meta = element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.2") \
        + element(2, 3, "UI", instance) + element(2, 0x10, "UI", "1.2.840.10008.1.2.1")
    body = element(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2") + element(8, 0x18, "UI", instance)
    body += element(8, 0x60, "CS", "CT") + element(0x20, 0xD, "UI", "1.2.3") + element(0x20, 0xE, "UI", "1.2.3.4")
    body += element(0x20, 0x32, "DS", f"10\\20\\{30 + 2 * z}") + element(0x20, 0x37, "DS", "0\\1\\0\\-1\\0\\0")
    for number, value in ((2, 1), (0x10, 2), (0x11, 3)):
        body += element(0x28, number, "US", struct.pack("<H", value))
        if number == 2:
            body += element(0x28, 4, "CS", "MONOCHROME2")
    body += element(0x28, 0x30, "DS", "1\\0.5")
    for number, value in ((0x100, 16), (0x101, 16), (0x102, 15), (0x103, 0)):
        body += element(0x28, number, "US", struct.pack("<H", value))
    body += element(0x28, 0x1052, "DS", "-150") + element(0x28, 0x1053, "DS", "1")
    body += element(0x7FE0, 0x10, "OW", pack("<H", GRID[6 * z:6 * z + 6]))
    return bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + body


os.makedirs(os.path.join(FOLDER, "series"), exist_ok=True)
for z in range(4):
    write(f"series/{9 - z}.dcm", dicom(z))

# --- meshes ---
CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
NORMALS = [(0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0)]
TRIANGLES = [t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))]


def lines(keyword, rows):
    return "".join(" ".join([keyword, *map(str, row)]).strip() + "\n" for row in rows)


UV = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
seams = "".join(("usemtl a\n" if i == 0 else "usemtl b\n" if i == 3 else "") + "f "
                + " ".join(f"{c + 1}/{k + 1}" for k, c in enumerate(quad)) + "\n" for i, quad in enumerate(QUADS))
write("cube_seams.obj", "# two materials, texture seams at every edge\n" + lines("v", CORNERS) + UV + seams)
hard = "".join("f " + " ".join(f"{c - 8}//{i + 1}" for c in quad) + "\n" for i, quad in enumerate(QUADS))
write("cube_normals.obj", lines("v", CORNERS) + lines("vn", NORMALS) + hard)


def ply_head(kind):
    return (f"ply\nformat {kind} 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n"
            "property float z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n")


def ply_binary(order):
    data = b"".join(struct.pack(order + "3f", *corner) for corner in CORNERS)
    return data + b"".join(struct.pack(order + "B3i", 3, *triangle) for triangle in TRIANGLES)


write("cube_ascii.ply", ply_head("ascii") + lines("", CORNERS) + lines("3", TRIANGLES))
write("cube_little.ply", ply_head("binary_little_endian").encode() + ply_binary("<"))
write("cube_big.ply", ply_head("binary_big_endian").encode() + ply_binary(">"))

FACETS = [[CORNERS[i] for i in triangle] for triangle in TRIANGLES]
write("cube_binary.stl", b"a cube".ljust(80) + struct.pack("<I", 12)
      + b"".join(struct.pack("<12fH", *NORMALS[i // 2], *(v for c in f for v in c), 0) for i, f in enumerate(FACETS)))
write("cube_ascii.stl", "solid cube\n" + "".join(
    "facet normal %d %d %d\nouter loop\n" % NORMALS[i // 2] + lines("vertex", f) + "endloop\nendfacet\n"
    for i, f in enumerate(FACETS)) + "endsolid cube\n")

# The cube twice: as it is, and mirrored in x, doubled and moved by (0, 0, 5) through a parent node.
POSITIONS = struct.pack("<24f", *(v for corner in CORNERS for v in corner))
INDICES = struct.pack("<36H", *(i for triangle in TRIANGLES for i in triangle))


def gltf(buffer):
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
            "nodes": [{"mesh": 0}, {"translation": [0, 0, 5], "children": [2]}, {"mesh": 0, "scale": [-2, 2, 2]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "buffers": [buffer],
            "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
                           "min": [0, 0, 0], "max": [1, 1, 1]},
                          {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]}


write("cubes.gltf", json.dumps(gltf({"byteLength": 168, "uri": "cubes.bin"}), indent=1) + "\n")
write("cubes.bin", POSITIONS + INDICES)
text = json.dumps(gltf({"byteLength": 168})).encode()
text += b" " * (-len(text) % 4)
write("cubes.glb", struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + 168, len(text), 0x4E4F534A) + text
      + struct.pack("<II", 168, 0x004E4942) + POSITIONS + INDICES)

# --- points ---
write("points.csv", b"\xef\xbb\xbfx, y ,z\r\n0,0.5,-1e-3\r\n +1.25 , 2,3\r\n\r\n \r\n")
