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

/// Depths first, then alphas: of the light as a whole, and of its colours where they differ.
const std::vector<std::string> kChannels{"Z", "ZBack", "A", "AR", "AG", "AB"};
enum Channel { kZ, kZBack, kAlpha };

constexpr int kTile = 64;  ///< texels per side

/// What readers cannot know from the samples.
constexpr const char* kInterpolation =
    "transmittance is linear in depth from Z to ZBack, while flattening takes it as exponential: the results agree at "
    "every Z and ZBack";

/// Of the light as a whole, of red, of green and of blue.
using Alphas = glm::dvec4;

struct Sample {
  float z, zBack;
  Alphas alpha;
};

Alphas transmittancesOf(const LightMap& map, std::size_t node) {
  const double mean = map.nodes[node].transmittance;
  return map.colors.empty() ? Alphas(mean) : Alphas(mean, glm::dvec3(map.colors[node]));
}

/// What a sample takes away: from `left` to `t`, of which nothing is left of what was nothing before.
Alphas alphasBetween(const Alphas& left, const Alphas& t) {
  Alphas alphas(0.0);
  for (int i = 0; i < 4; ++i)
    if (left[i] > 0.0) alphas[i] = 1.0 - t[i] / left[i];
  return alphas;
}

/// The samples of one texel, of the nodes [first, last). A step down at one depth is a surface, all else a sample from
/// node to node.
std::vector<Sample> samplesOf(const LightMap& map, std::size_t first, std::size_t last) {
  std::vector<Sample> samples;
  float depth = first < last ? map.nodes[first].depth : 0.0f;
  Alphas left(1.0);  // transmittances behind the samples so far
  for (std::size_t i = first; i < last && left[0] > 0.0; ++i) {
    const Alphas transmittances = glm::clamp(transmittancesOf(map, i), Alphas(0.0), left);
    const float next = map.nodes[i].depth;
    if (next > depth || transmittances != left) samples.push_back({depth, next, alphasBetween(left, transmittances)});
    depth = next;
    left = transmittances;
  }
  return samples;
}

OIIO::ImageSpec specOf(const Light& light, const LightMap& map, MapFileLayout layout) {
  const int channels = map.colors.empty() ? kAlpha + 1 : int(kChannels.size());
  OIIO::ImageSpec spec(map.width, map.height, channels, OIIO::TypeDesc::FLOAT);
  spec.channelnames.assign(kChannels.begin(), kChannels.begin() + channels);
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
    samples[texel] = samplesOf(map, map.firstNode[texel], map.firstNode[texel + 1]);
    counts[texel] = unsigned(samples[texel].size());
  }
  OIIO::DeepData deep(spec);
  deep.set_all_samples(counts);
  for (std::size_t texel = 0; texel < texels; ++texel)
    for (int i = 0; i < int(counts[texel]); ++i) {
      const Sample& sample = samples[texel][std::size_t(i)];
      deep.set_deep_value(std::int64_t(texel), kZ, i, sample.z);
      deep.set_deep_value(std::int64_t(texel), kZBack, i, sample.zBack);
      for (int channel = kAlpha; channel < spec.nchannels; ++channel)
        deep.set_deep_value(std::int64_t(texel), channel, i, float(sample.alpha[channel - kAlpha]));
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
