// SPDX-License-Identifier: Apache-2.0
// In: an OBJ, PLY, STL or glTF file. Out: all its triangles as one mesh in object space, or an Error.
#pragma once

#include <memory>
#include <string>

#include <cdsm/scene.hpp>

namespace cdsm::io {

/// Reads .obj, .ply, .stl, .gltf or .glb: all meshes, with the file's node transforms, polygons cut into triangles.
/// Equal vertices (position, and normal if kept) become one; points, lines, triangles without area and vertices that no
/// triangle uses are left out. Normals are the file's own, kept only if every vertex has one; STL's, which are those of
/// the flat triangles, are not. Throws Error for damaged files and for files without triangles. Safe from many threads.
std::shared_ptr<const MeshData> readMesh(const std::string& path);

}  // namespace cdsm::io
