// SPDX-License-Identifier: Apache-2.0
// Suite "chunks" [Knecht 2011, Table 5.11]: room that chunks take and waste while maps are built. A chunk of the thesis
// holds 64 nodes of 8 x 8 texels, one of ours 8 nodes of one texel, so room is counted in 64 nodes here: used by nodes,
// wasted by places in chunks that stay empty and by chunks that are lost.
#include "bench_scenes.hpp"
#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr double kNodesOfChunk = 8.0, kNodesOfThesisChunk = 64.0, kTexelsOfBlock = 64.0;

/// Of the eight scenes (a) to (h): the thesis does not say in its text which they are.
const std::vector<double> kThesisUsed = {2.4, 2.5, 1.9, 1.6, 1.1, 2.0, 4.0, 3.9};
const std::vector<double> kThesisWasted = {22.7, 21.7, 19.0, 14.1, 10.0, 12.5, 21.2, 17.0};

Row thesisRow(const char* label, const std::vector<double>& thesis) {
  Row row = plainRow(label);
  row.thesis = thesis;
  return row;
}

}  // namespace

std::vector<Table> benchChunks(const BenchOptions& options) {
  Row used = plainRow("used: room for 64 nodes"), wasted = plainRow("wasted: room for 64 nodes");
  Row ratio = plainRow("wasted / used"), kept = plainRow("bytes of finished maps");
  Row lost = plainRow("chunks never written to, in all");
  forEachPaperScene(options, [&](Subject& subject) {
    subject.shrinkImage();
    subject.frameMs();
    const MemoryStats& memory = subject.stats().memory;
    double texels = 0.0, nodes = 0.0;
    for (const LightStats& light : subject.stats().lights) {
      for (const MapStats& map : light.maps) {
        texels += double(map.texels);
        nodes += double(map.nodesTotal);
      }
    }
    const double blocks = texels / kTexelsOfBlock, perBlock = kNodesOfThesisChunk * blocks;
    const double room = kNodesOfChunk * double(memory.chunksUsed + memory.chunksWasted);
    used.ours.push_back(nodes / perBlock);
    wasted.ours.push_back((room - nodes) / perBlock);
    ratio.ours.push_back((room - nodes) / nodes);
    kept.ours.push_back(double(memory.bytesReserved) / blocks);
    lost.ours.push_back(double(memory.chunksWasted));
  });
  std::vector<double> thesisRatio;
  for (std::size_t i = 0; i < kThesisUsed.size(); ++i) thesisRatio.push_back(kThesisWasted[i] / kThesisUsed[i]);
  const std::string per = "average for a block of 8 x 8 texels";
  return {{"chunks", "Table 5.11, ours: " + per, "scene", paperColumns(), {used, wasted, ratio, kept, lost}},
          {"thesis",
           "Table 5.11, thesis: " + per,
           "scene",
           {"(a)", "(b)", "(c)", "(d)", "(e)", "(f)", "(g)", "(h)"},
           {thesisRow("used chunks of 64 nodes", kThesisUsed), thesisRow("wasted chunks of 64 nodes", kThesisWasted),
            thesisRow("wasted / used", thesisRatio)}}};
}

}  // namespace cdsm::cli
