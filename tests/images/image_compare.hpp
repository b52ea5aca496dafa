// SPDX-License-Identifier: Apache-2.0
// In: a rendered image and its reference. Out: how many pixels differ, and on failure three pictures to look at.
#pragma once

#include <string>

#include <cdsm/cdsm.hpp>

namespace cdsm::images {

/// The part of the pixels whose channels all lie within `limit` of each other, as shown: colours cut to [0, 1].
double partWithin(const Image& a, const Image& b, float limit);

/// Writes NAME_render.exr, NAME_reference.exr and NAME_difference.png (ten times the difference) into the current
/// folder.
void writeFailure(const std::string& name, const Image& render, const Image& reference);

}  // namespace cdsm::images
