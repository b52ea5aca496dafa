// SPDX-License-Identifier: Apache-2.0
// What somebody probably meant by a misspelt name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cdsm::io {

/// "a, b, c".
std::string joinNames(const std::vector<std::string>& names);

/// What to append to "unknown ... 'wrong'": ", did you mean 'x'?" when one of the names is near, or else ", must be one
/// of: a, b, c".
std::string suggestion(std::string_view wrong, const std::vector<std::string>& names);

}  // namespace cdsm::io
