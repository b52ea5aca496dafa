// SPDX-License-Identifier: Apache-2.0
// In: a CSV of points "x,y,z". Out: the points; and back, with the light at them, "x,y,z,lit,transmittance"
// or "x,y,z,lit,r,g,b".
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::io {

/// World points in the file's order. The header is exactly x,y,z; spaces around values, CR LF, a byte order mark and
/// blank lines at the end are allowed. No points are no error. Throws Error with line and column.
std::vector<glm::vec3> readPoints(const std::string& path);

/// What a row says of the light.
enum class LightColumns { Transmittance, Colors };

/// Writes one row per point, in order, in the shortest digits that read back as the same floats. Throws Error if the
/// numbers of points and answers differ or the stream fails.
void writeTransmittances(std::ostream& out, const std::vector<glm::vec3>& points,
                         const std::vector<Transmittance>& transmittances,
                         LightColumns columns = LightColumns::Transmittance);

/// The same into a file, whole or not at all; "-" is standard output.
void writeTransmittances(const std::string& path, const std::vector<glm::vec3>& points,
                         const std::vector<Transmittance>& transmittances,
                         LightColumns columns = LightColumns::Transmittance);

}  // namespace cdsm::io
