// SPDX-License-Identifier: Apache-2.0
#include "io/data_uri.hpp"

#include <OpenImageIO/strutil.h>

#include "io/input_file.hpp"

namespace cdsm::io {

std::string pngDataUri(const std::string& path) {
  return "data:image/png;base64," + OIIO::Strutil::base64_encode(readText(path));
}

}  // namespace cdsm::io
