// SPDX-License-Identifier: Apache-2.0
// In: a NRRD file (.nrrd) or NRRD header beside its data (.nhdr). Out: the grid as stored. The header is teem's affair;
// the data (raw, gzip, ascii) are read here, because teem would allocate and convert on the word of the header.
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// Axes come from "space directions" and "space origin", else from "spacings" (1 where there is none) and 0; axes
/// without direction of size 1 are dropped. Throws Error for all that is not one scalar, three-dimensional grid.
StoredVolume readNrrd(const std::string& path);

}  // namespace cdsm::io
