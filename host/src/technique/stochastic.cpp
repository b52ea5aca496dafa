// SPDX-License-Identifier: Apache-2.0
#include "technique/stochastic.hpp"

#include <algorithm>
#include <cmath>

namespace cdsm::technique {

namespace {

/// How photon numbers go on from texel to texel, so that those of one lookup are spread evenly over 0 .. 1: a lattice,
/// the number of texel (x, y) is the fraction of (x * along + y * down) / count, and some noise, so that it does not
/// show. Found by search over all lattices with count < 100 for the lookup's offsets; the error of a lookup is then
/// less than a quarter of that of independent numbers.
struct Lattice {
  int samples;
  unsigned count, along, down;
  double noise;  ///< width of what each texel adds by itself
};

constexpr Lattice kLattices[] = {{7, 7, 1, 3, 0.15}, {13, 89, 33, 60, 0.15}, {21, 64, 23, 43, 0.1}};

/// A part of a turn in units of 2^-32.
shared::uint turn(double part) { return shared::uint(std::min(std::floor(part * 4294967296.0), 4294967295.0)); }

/// Independent numbers for the texels, the same ones for the channels of each [Weidner & Linsen 2018, Table 1].
void drawPublished(shared::DepthParams& params) { params.jitter = turn(1.0); }

/// Grey light has three photons per texel for one transmittance: their numbers are a third of a turn apart, so that a
/// third of a turn is what has to be spread over the texels. Those of colours share a number, as published: what is
/// grey stays grey.
void drawStratified(shared::DepthParams& params, int samples, bool colored) {
  const Lattice& lattice = *std::find_if(std::begin(kLattices), std::end(kLattices),
                                         [&](const Lattice& candidate) { return candidate.samples == samples; });
  const double whole = colored ? 1.0 : 1.0 / 3.0;
  params.patternX = turn(whole * lattice.along / lattice.count);
  params.patternY = turn(whole * lattice.down / lattice.count);
  params.jitter = turn(whole * lattice.noise);
  params.channelShift = colored ? 0 : turn(whole);
}

}  // namespace

build::StopRule Stochastic::stopRule(const Preparation& to) {
  const ShadowSettings& shadows = to.scene.shadows;
  build::StopRule rule{"\"build/stop_random.clh\"", {}, {}};
  rule.params.seed = shared::uint(shadows.seed);
  if (shadows.stratified)
    drawStratified(rule.params, shadows.samples, shadows.transmittance == "rgb");
  else
    drawPublished(rule.params);
  return rule;
}

float Stochastic::lookupTolerance(const Scene& scene) const {
  return std::max(scene.shadows.tolerance, 0.5f / std::sqrt(float(scene.shadows.samples)));
}

shared::TechniqueParams Stochastic::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.bilinear = scene.shadows.filter == "bilinear";
  params.texelBias = texelBias(scene);
  params.samples = scene.shadows.samples;
  return params;
}

}  // namespace cdsm::technique
