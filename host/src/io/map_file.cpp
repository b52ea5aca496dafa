// SPDX-License-Identifier: Apache-2.0
// Deep EXR through OpenImageIO; see map_file.hpp.
#include "io/map_file.hpp"

#include <algorithm>
#include <memory>

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>

#include <cdsm/error.hpp>

#include "io/atomic_file.hpp"
#include "io/input_file.hpp"
#include "io/text_numbers.hpp"
#include "scene/light_names.hpp"

namespace cdsm::io {

namespace {

enum Channel { kAlpha, kZ, kZBack };

constexpr int kTile = 64;  ///< texels per side

/// What readers cannot know from the samples.
constexpr const char* kInterpolation =
    "transmittance is linear in depth from Z to ZBack, while flattening takes it as exponential: the results agree at "
    "every Z and ZBack";

struct Sample {
  float z, zBack, alpha;
};

/// The samples of one texel. A step down at one depth is a surface, all else a sample from node to node.
std::vector<Sample> samplesOf(const MapNode* nodes, std::size_t count) {
  std::vector<Sample> samples;
  float depth = count > 0 ? nodes[0].depth : 0.0f;
  double left = 1.0;  // transmittance behind the samples so far
  for (std::size_t i = 0; i < count && left > 0.0; ++i) {
    const double transmittance = std::clamp(double(nodes[i].transmittance), 0.0, left);
    if (nodes[i].depth > depth || transmittance < left)
      samples.push_back({depth, nodes[i].depth, float(1.0 - transmittance / left)});
    depth = nodes[i].depth;
    left = transmittance;
  }
  return samples;
}

OIIO::ImageSpec specOf(const Light& light, const LightMap& map, MapFileLayout layout) {
  OIIO::ImageSpec spec(map.width, map.height, 3, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"A", "Z", "ZBack"};
  spec.alpha_channel = kAlpha;
  spec.z_channel = kZ;
  spec.deep = true;
  if (layout == MapFileLayout::Tiles) spec.tile_width = spec.tile_height = kTile;
  const std::string place = ".cluster" + std::to_string(map.cluster) + ".map" + std::to_string(map.number);
  spec.attribute("oiio:subimagename", light.name + place);
  // same input, same bytes: OpenImageIO would write the time of day
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  // the columns of GLM are the rows of Imath, which multiplies a point by the matrix from the right
  spec.attribute("worldToCamera", OIIO::TypeMatrix, &map.cameraFromWorld[0][0]);
  spec.attribute("worldToNDC", OIIO::TypeMatrix, &map.pictureFromWorld[0][0]);
  spec.attribute("cdsm:light", light.name);
  spec.attribute("cdsm:lightType", scene::nameOf(light.type));
  spec.attribute("cdsm:cluster", map.cluster);
  spec.attribute("cdsm:map", map.number);
  if (!map.side.empty()) spec.attribute("cdsm:side", map.side);
  std::vector<OIIO::ustring> objects(map.objects.begin(), map.objects.end());
  if (!objects.empty())
    spec.attribute("cdsm:objects", OIIO::TypeDesc(OIIO::TypeDesc::STRING, int(objects.size())), objects.data());
  spec.attribute("cdsm:near", map.nearDepth);
  spec.attribute("cdsm:far", map.farDepth);
  spec.attribute("cdsm:tolerance", map.tolerance);
  spec.attribute("cdsm:interpolation", kInterpolation);
  return spec;
}

OIIO::DeepData deepData(const OIIO::ImageSpec& spec, const LightMap& map) {
  const std::size_t texels = map.firstNode.size() - 1;
  std::vector<std::vector<Sample>> samples(texels);
  std::vector<unsigned> counts(texels);
  for (std::size_t texel = 0; texel < texels; ++texel) {
    const std::size_t first = map.firstNode[texel];
    samples[texel] = samplesOf(map.nodes.data() + first, map.firstNode[texel + 1] - first);
    counts[texel] = unsigned(samples[texel].size());
  }
  OIIO::DeepData deep(spec);
  deep.set_all_samples(counts);
  for (std::size_t texel = 0; texel < texels; ++texel)
    for (int i = 0; i < int(counts[texel]); ++i) {
      const Sample& sample = samples[texel][std::size_t(i)];
      deep.set_deep_value(std::int64_t(texel), kAlpha, i, sample.alpha);
      deep.set_deep_value(std::int64_t(texel), kZ, i, sample.z);
      deep.set_deep_value(std::int64_t(texel), kZBack, i, sample.zBack);
    }
  return deep;
}

void writeTo(const std::string& file, const std::string& path, const std::vector<OIIO::ImageSpec>& specs,
             const std::vector<LightMap>& maps) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
  if (!output) throw Error(Location{path}, "cannot be written: " + printable(OIIO::geterror()));
  bool written = output->open(file, int(specs.size()), specs.data());
  for (std::size_t i = 0; written && i < maps.size(); ++i) {
    if (i > 0) written = output->open(file, specs[i], OIIO::ImageOutput::AppendSubimage);
    written = written && output->write_deep_image(deepData(specs[i], maps[i]));
  }
  if (!written || !output->close()) throw Error(Location{path}, "cannot be written: " + printable(output->geterror()));
}

}  // namespace

void writeLightMaps(const std::string& path, const Light& light, const std::vector<LightMap>& maps,
                    MapFileLayout layout) {
  checkMapPath(path);
  if (maps.empty())
    throw Error("light '" + light.name + "' has no maps to write: nothing that casts a shadow is in its reach");
  std::vector<OIIO::ImageSpec> specs;
  for (const LightMap& map : maps) specs.push_back(specOf(light, map, layout));
  AtomicFile file(path);
  writeTo(file.temporaryPath(), path, specs, maps);
  file.commit();
}

void checkMapPath(const std::string& path) {
  if (!hasEnding(path, ".exr"))
    throw Error(Location{path}, "must end in .exr: deep shadow maps are written as deep EXR");
  checkOutputPath(path);
}

}  // namespace cdsm::io
