// SPDX-License-Identifier: Apache-2.0
// A camera that goes around what it looks at.
#pragma once

#include <cdsm/cdsm.hpp>

namespace cdsm::cli {

/// The camera turned about the axis of its `up` through its target, by degrees.
Camera turned(const Camera& camera, float degrees);

}  // namespace cdsm::cli
