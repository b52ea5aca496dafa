// SPDX-License-Identifier: Apache-2.0
// In: a file. Out: its bytes as text that stands in the place of its address in a web page.
#pragma once

#include <string>

namespace cdsm::io {

/// "data:image/png;base64,...". Throws Error if the file cannot be read.
std::string pngDataUri(const std::string& path);

}  // namespace cdsm::io
