// SPDX-License-Identifier: Apache-2.0
// New device buffers can be filled with a byte of the test's choice: results must not depend on it.
#pragma once

#include <optional>

namespace cdsm::devices {

/// What fills buffers that are created from now on in this process; none: they are left as they are.
void poisonNewBuffers(std::optional<unsigned char> byte);

}  // namespace cdsm::devices
