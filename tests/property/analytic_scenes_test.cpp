// SPDX-License-Identifier: Apache-2.0
// The scenes of scenes/analytic as a user has them: scene file, points, and the answers of the formula in its head.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine_paths.hpp"
#include "io/points_file.hpp"
#include "io/scene_file.hpp"

namespace cdsm::property {
namespace {

constexpr double kMapLimit =
    8e-3;  ///< the scenes' tolerance of 0.002, and the nearest texels' other angles to the axis
constexpr double kRayLimit = 2e-3;  ///< the midpoint rule in the ramp

std::string fileOf(const std::string& name) {
  return (std::filesystem::path(CDSM_TEST_DATA) / "../../scenes/analytic" / name).string();
}

/// The columns lit and transmittance of NAME.csv.
std::vector<Transmittance> answersOf(const std::string& name) {
  std::ifstream file(fileOf(name + ".csv"));
  std::string row;
  std::getline(file, row);
  std::vector<Transmittance> answers;
  while (std::getline(file, row)) {
    std::stringstream cells(row);
    std::vector<double> numbers;
    for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
    answers.push_back({static_cast<std::uint8_t>(numbers.at(3)), static_cast<float>(numbers.at(4))});
  }
  return answers;
}

class AnalyticScenes : public ::testing::TestWithParam<std::string> {};

TEST_P(AnalyticScenes, giveTheFormulasAnswers) {
  Scene scene = io::readScene(fileOf(GetParam() + ".toml"));
  const std::vector<glm::vec3> points = io::readPoints(fileOf("points.csv"));
  const std::vector<Transmittance> answers = answersOf(GetParam());
  ASSERT_EQ(answers.size(), points.size());
  EXPECT_LE(largestDifference(query(mapPath(), scene, points), answers), kMapLimit);
  scene.shadows.technique = "shadow-rays";
  EXPECT_LE(largestDifference(query(rayPath(), scene, points), answers), kRayLimit);
}

INSTANTIATE_TEST_SUITE_P(Files, AnalyticScenes,
                         ::testing::Values("slab", "overlapping_slabs", "ramp", "sheets", "medium_box"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace cdsm::property
