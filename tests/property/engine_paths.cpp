// SPDX-License-Identifier: Apache-2.0
// Shared engines and the table of paths of the property and image tests.
#include "engine_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace cdsm::property {
namespace {

/// Owns the engines: they must be gone before static objects die, as OpenCL implementations are unloaded then.
class EnginePool : public ::testing::Environment {
 public:
  Engine& get(const std::string& fetch) {
    std::unique_ptr<Engine>& engine = engines_[fetch];
    if (!engine) {
      EngineOptions options;
      options.fetch = fetch;
      engine = std::make_unique<Engine>(options);
    }
    return *engine;
  }
  void TearDown() override { engines_.clear(); }

 private:
  std::map<std::string, std::unique_ptr<Engine>> engines_;
};

EnginePool* const pool = new EnginePool;  // owned by the test program below
const ::testing::Environment* const registered = ::testing::AddGlobalTestEnvironment(pool);

}  // namespace

std::string Path::name() const {
  const std::string what = technique == "deep-shadow-map" ? "Map" + memory + filter : "Rays";
  return what + (format == "float32" ? "" : format) + fetch +
         (clusters > 1 ? "Clusters" + std::to_string(clusters) : "");
}

std::vector<Path> allPaths() {
  std::vector<Path> paths;
  for (const char* fetch : {"buffer", "image"}) {
    paths.push_back({"shadow-rays", "chunked", "bilinear", fetch});
    for (const char* memory : {"atlas", "chunked", "exact", "tiled"}) {
      for (const char* filter : {"nearest", "bilinear"}) paths.push_back({"deep-shadow-map", memory, filter, fetch});
    }
    paths.push_back({"deep-shadow-map", "exact", "bilinear", fetch, 1, "unorm16"});
  }
  return paths;
}

Path mapPath(const std::string& memory, const std::string& filter, int clusters) {
  return {"deep-shadow-map", memory, filter, "buffer", clusters};
}

Path rayPath() { return {"shadow-rays", "chunked", "bilinear", "buffer"}; }

Engine& engineOf(const std::string& fetch) { return pool->get(fetch); }

bool canFetch(const std::string& fetch) { return fetch != "image" || engineOf("buffer").device().images; }

Scene along(const Path& path, Scene scene, int mapSize, float tolerance) {
  scene.shadows.technique = path.technique;
  scene.shadows.memory = path.memory;
  scene.shadows.nodeFormat = path.format;
  scene.shadows.filter = path.filter;
  scene.shadows.clusters = path.clusters;
  scene.shadows.mapSize = mapSize;
  scene.shadows.tolerance = tolerance;
  return scene;
}

std::vector<Transmittance> query(const Path& path, const Scene& scene, const std::vector<glm::vec3>& points,
                                 const std::string& light) {
  return engineOf(path.fetch).transmittance(scene, light, points);
}

double largestDifference(const std::vector<Transmittance>& a, const std::vector<Transmittance>& b) {
  if (a.size() != b.size()) return 2.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(static_cast<double>(a[i].transmittance) - b[i].transmittance);
    largest = std::max(largest, a[i].lit == b[i].lit && difference == difference ? difference : 2.0);
  }
  return largest;
}

}  // namespace cdsm::property
