// SPDX-License-Identifier: Apache-2.0
// In: a MetaImage (.mha, or .mhd with its data beside it). Out: the grid as stored. The small header is parsed here.
#pragma once

#include <string>

#include "io/stored_volume.hpp"

namespace cdsm::io {

/// Keys read: ObjectType NDims DimSize ElementType ElementNumberOfChannels ElementSpacing ElementSize Offset/Position/
/// Origin TransformMatrix/Rotation/Orientation (row i: the direction of axis i) BinaryData BinaryDataByteOrderMSB/
/// ElementByteOrderMSB CompressedData HeaderSize ElementDataFile. Throws Error with the line of the header.
StoredVolume readMetaImage(const std::string& path);

}  // namespace cdsm::io
