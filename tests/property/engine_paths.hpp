// SPDX-License-Identifier: Apache-2.0
// The ways through the engine that have to agree: technique, memory, filter, fetch, clusters. Engines are made on first
// use, shared by all tests of the program and freed before it ends.
#pragma once

#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::property {

struct Path {
  std::string technique;
  std::string memory;
  std::string filter;
  std::string fetch;
  int clusters = 1;
  std::string format = "float32";
  std::string name() const;  ///< letters and digits alone
};

/// Every combination that makes sense, without clusters: shadow rays have neither memory nor filter.
std::vector<Path> allPaths();
/// deep-shadow-map, bilinear, buffer, with that memory, nodes of 8 bytes.
Path mapPath(const std::string& memory = "chunked", const std::string& filter = "bilinear", int clusters = 1);
Path rayPath();

/// The shared engine that fetches this way ("buffer" or "image").
Engine& engineOf(const std::string& fetch);
/// False for "image" where the device has none.
bool canFetch(const std::string& fetch);

/// The scene with the path's settings.
Scene along(const Path& path, Scene scene, int mapSize, float tolerance);

/// Asks for light "key" unless another is named.
std::vector<Transmittance> query(const Path& path, const Scene& scene, const std::vector<glm::vec3>& points,
                                 const std::string& light = "key");

/// The largest difference of the transmittances; 2 where the sizes or `lit` differ.
double largestDifference(const std::vector<Transmittance>& a, const std::vector<Transmittance>& b);

}  // namespace cdsm::property
