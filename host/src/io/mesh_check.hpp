// SPDX-License-Identifier: Apache-2.0
// In: mesh files before assimp sees them. Out: the number of faces that assimp must find, or an Error with the place of
// what is wrong. assimp passes over much of this in silence or crashes on it.
#pragma once

#include <cstdint>
#include <string>

namespace cdsm::io {

/// Vertex lines hold finite numbers, faces name vertices that exist.
std::uint64_t checkObj(const std::string& path);

/// The header's counts agree with the data, faces name vertices that exist.
std::uint64_t checkPly(const std::string& path);

/// Binary: the size is that of the triangles counted; text: every facet is complete.
std::uint64_t checkStl(const std::string& path);

/// The container is complete, JSON's indices point to what exists, nodes form trees, and accessors stay in buffers.
std::uint64_t checkGltf(const std::string& path);

}  // namespace cdsm::io
