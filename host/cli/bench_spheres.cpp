// SPDX-License-Identifier: Apache-2.0
// Suite "spheres" [Krone 2017, §4.1, Fig. 8]: frames of molecules by local lighting alone, by implicit sphere shadow
// maps, and with ambient occlusion, in the paper's viewport with the paper's size of maps.
#include <algorithm>
#include <cmath>

#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr int kWidth = 1920, kHeight = 1200, kMapSize = 512;
constexpr double kWanted = 1.25;
/// Of the weaker of the paper's two systems: 80 % of the frame rate of local lighting, whatever the data.
constexpr double kPaperShadows = 1.0 / 0.8;
/// Of its largest data: 33 frames a second with shadows, 31 with ambient occlusion too.
constexpr double kPaperOcclusion = kPaperShadows * 33.0 / 31.0;

struct Molecule {
  const char* file;  ///< in papers/molecules
  const char* name;
  bool inPaper;  ///< or something as large in its place
  bool largest;
};

constexpr Molecule kMolecules[] = {{"1tii", "1TII", true, false},         {"1lnl", "1LNL", false, false},
                                   {"1aon", "1AON", true, false},         {"nial_impact", "NiAl", true, false},
                                   {"capsid", "1IHM capsid", true, true}, {"million", "silver ball", true, true}};

struct Figures {
  double spheres = 0.0;
  double local = 0.0, kept = 0.0, built = 0.0;     ///< ms of a frame; `built`: with a new map
  double occludedKept = 0.0, occludedBuilt = 0.0;  ///< the same with ambient occlusion that is there
  double buildMap = 0.0, buildOcclusion = 0.0;     ///< ms
};

Scene sceneOf(const BenchOptions& options, const Molecule& molecule) {
  Scene scene = readBenchScene(options, "papers/molecules/" + std::string(molecule.file) + ".toml");
  scene.image.width = std::max(16, int(std::lround(options.scale * kWidth)));
  scene.image.height = std::max(10, int(std::lround(options.scale * kHeight)));
  scene.shadows.mapSize = scaledMapSize(options, kMapSize);
  scene.shadows.technique = "none";
  return scene;
}

double sphereCount(const Scene& scene) {
  double count = 0.0;
  for (const Spheres& spheres : scene.spheres) count += double(spheres.data->centers.size());
  return count;
}

Figures measure(const BenchOptions& options, Scene scene) {
  Figures figures;
  figures.spheres = sphereCount(scene);
  Subject local(options, scene);
  scene.shadows.technique = "implicit-sphere";
  Subject shadows(options, scene);
  scene.ambientOcclusion.emplace();
  Subject occlusion(options, scene);
  occlusion.render();
  figures.buildOcclusion = occlusion.stats().ambientOcclusionMs;
  const auto frames = [](Subject& subject) {
    const double built = subject.movedLightMs();
    return std::vector<double>{subject.frameMs(), built};
  };
  const auto times = mediansInTurn(
      options, {[&] { return frames(local); }, [&] { return frames(shadows); }, [&] { return frames(occlusion); }});
  figures.local = times[0][0];
  figures.kept = times[0][1];
  figures.built = times[1][1];
  figures.occludedKept = times[0][2];
  figures.occludedBuilt = times[1][2];
  figures.buildMap = mediansInTurn(options, {[&] { return std::vector<double>{shadows.buildMs()}; }})[0][0];
  return figures;
}

/// A row of one figure of all molecules.
Row rowOf(const char* label, const char* unit, const std::vector<Figures>& all, double Figures::*figure) {
  Row row = plainRow(label, unit);
  for (const Figures& figures : all) row.ours.push_back(figures.*figure);
  return row;
}

/// The same over that of local lighting; `paper`: its figure for what is in it, or for the largest alone.
Row ratioOf(const char* label, const std::vector<Figures>& all, double Figures::*figure, double paper, bool largest) {
  Row row = plainRow(label);
  for (std::size_t i = 0; i < all.size(); ++i) {
    row.ours.push_back(all[i].*figure / all[i].local);
    const Molecule& molecule = kMolecules[i];
    row.thesis.push_back(molecule.inPaper && (molecule.largest || !largest) ? paper : kNoFigure);
  }
  return row;
}

}  // namespace

std::vector<Table> benchSpheres(const BenchOptions& options) {
  std::vector<Figures> all;
  std::vector<std::string> names;
  for (const Molecule& molecule : kMolecules) {
    all.push_back(measure(options, sceneOf(options, molecule)));
    names.push_back(molecule.name);
  }
  Row kept = ratioOf("implicit spheres, map kept", all, &Figures::kept, kPaperShadows, false);
  Row built = ratioOf("implicit spheres, a new map in each frame", all, &Figures::built, kPaperShadows, false);
  kept.wanted.assign(all.size(), kWanted);
  built.wanted.assign(all.size(), kWanted);
  const Table ratios{
      "krone-8",
      "Krone's Figure 8: frames / frames by local lighting alone, map of " + mapSizeText(options, kMapSize, 1),
      "molecule",
      names,
      {kept, built, ratioOf("and ambient occlusion, map kept", all, &Figures::occludedKept, kPaperOcclusion, true),
       ratioOf("and ambient occlusion, a new map", all, &Figures::occludedBuilt, kPaperOcclusion, true)},
      {},
      "paper"};
  const Table times{"times",
                    "What they are made of",
                    "molecule",
                    names,
                    {rowOf("spheres", "", all, &Figures::spheres), rowOf("local lighting", "ms", all, &Figures::local),
                     rowOf("implicit spheres, map kept", "ms", all, &Figures::kept),
                     rowOf("implicit spheres, a new map", "ms", all, &Figures::built),
                     rowOf("building the map", "ms", all, &Figures::buildMap),
                     rowOf("making ambient occlusion", "ms", all, &Figures::buildOcclusion)},
                    {},
                    "paper"};
  return {ratios, times};
}

}  // namespace cdsm::cli
