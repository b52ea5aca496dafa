// SPDX-License-Identifier: Apache-2.0
// The compression of visibility functions alone: random falling ramps and steps through build/compress.clh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"
#include "shared/types.h"

namespace cdsm::kernels {
namespace {

using shared::float2;
using shared::float4;
using Nodes = device::Buffer<float2>;

/// A memory strategy of one plain array per function.
const char* const kMemory = R"(
typedef float2 Node;
typedef struct NodeWriter { __global Node* nodes; uint capacity, count; } NodeWriter;
void writeNode(NodeWriter* w, Node node) { if (w->count < w->capacity) w->nodes[w->count] = node; ++w->count; }
)";

/// An item per function. Events: (from, to, t, 0) a ramp, (z, z, t, 1) a surface; firsts[i] .. firsts[i + 1].
const char* const kText = R"(
#include "common/math.clh"
#include "build/compress.clh"
__kernel void compress(uint functions, float tolerance, uint capacity, __global const float4* events,
                       __global const uint* firsts, __global float2* nodes, __global uint* counts) {
  uint i = (uint)get_global_id(0);
  if (i >= functions) return;
  VisibilityBuilder b;
  b.writer.nodes = nodes + i * capacity;
  b.writer.capacity = capacity;
  b.writer.count = 0;
  b.tolerance = tolerance;
  b.started = false;
  for (uint k = firsts[i]; k < firsts[i + 1]; ++k) {
    float4 e = events[k];
    if (e.w > 0.0f)
      dropAt(&b, e.x, e.z);
    else
      fallTo(&b, e.x, e.y, e.z);
  }
  finishVisibility(&b);
  counts[i] = b.writer.count;
}
)";

struct Event {
  float from, to, t;
  bool surface;
};
using Function = std::vector<Event>;
using Compressed = std::vector<float2>;

std::vector<Compressed> compress(const std::vector<Function>& functions, float tolerance) {
  device::Device& device = deviceOf();
  std::vector<float4> events;
  std::vector<std::uint32_t> firsts{0};
  std::size_t longest = 0;
  for (const Function& f : functions) {
    for (const Event& e : f) events.emplace_back(e.from, e.to, e.t, e.surface ? 1.0f : 0.0f);
    firsts.push_back(std::uint32_t(events.size()));
    longest = std::max(longest, f.size());
  }
  const std::size_t capacity = 4 * longest + 8;
  const auto in = device::Buffer<float4>::fromHost(device, events, "events");
  const auto starts = device::Buffer<std::uint32_t>::fromHost(device, firsts, "firsts");
  Nodes nodes(device, functions.size() * capacity, "nodes");
  device::Buffer<std::uint32_t> counts(device, functions.size(), "counts");
  const cl::Program& program = testProgram(device, kText, {{"CDSM_MEMORY", "\"test/memory.clh\""}, {"CDSM_BATCH", "4"}},
                                           {{"test/memory.clh", kMemory}});
  device::Kernel<std::uint32_t, float, std::uint32_t, device::Buffer<float4>, device::Buffer<std::uint32_t>, Nodes,
                 device::Buffer<std::uint32_t>>
      kernel(device, program, "compress");
  kernel({"compress", {functions.size()}, {kGroup}}, std::uint32_t(functions.size()), tolerance,
         std::uint32_t(capacity), in, starts, nodes, counts);
  const std::vector<float2> all = nodes.download();
  std::vector<Compressed> result;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const std::size_t count = counts.read(i);
    EXPECT_LE(count, capacity);
    const auto first = all.begin() + std::ptrdiff_t(i * capacity);
    result.emplace_back(first, first + std::ptrdiff_t(std::min(count, capacity)));
  }
  return result;
}

/// V' at z: 1 in front of the first node, the last value behind the last one; at an upright step the value in front, or
/// (`behind`) the one behind it.
double valueAt(const Compressed& nodes, double z, bool behind) {
  std::size_t low = 0;
  while (low < nodes.size() && (behind ? nodes[low].x <= z : nodes[low].x < z)) ++low;
  if (low == 0) return 1.0;
  if (low == nodes.size()) return nodes.back().y;
  const double span = double(nodes[low].x) - nodes[low - 1].x;
  return nodes[low - 1].y + (double(nodes[low].y) - nodes[low - 1].y) * (z - nodes[low - 1].x) / span;
}

/// Rounding of slopes: some units of the last place of values up to 1, magnified by depth / (depth since the origin).
constexpr double kRounding = 2e-6;

void expectWithin(const Function& function, const Compressed& nodes, double tolerance, const std::string& what) {
  double before = 1.0;
  float depth = 0.0f;
  for (std::size_t i = 0; i < function.size(); ++i) {
    const Event& e = function[i];
    const bool lastThere = i + 1 == function.size() || function[i + 1].from > e.from;
    // in front of the event V holds; at a surface it jumps, at a ramp it falls linearly
    if (e.from > depth) EXPECT_NEAR(valueAt(nodes, e.from, false), before, tolerance + kRounding) << what << e.from;
    if (e.surface && lastThere)
      EXPECT_NEAR(valueAt(nodes, e.from, true), e.t, tolerance + kRounding) << what << "behind " << e.from;
    for (int k = 0; !e.surface && k <= 4; ++k) {
      const double z = e.from + 0.25 * k * (double(e.to) - e.from), exact = before + 0.25 * k * (e.t - before);
      EXPECT_NEAR(valueAt(nodes, z, k == 0), exact, tolerance + kRounding) << what << z;
    }
    before = e.t;
    depth = e.to;
  }
}

void expectSound(const Function& function, const Compressed& nodes, const std::string& what) {
  std::size_t samples = 2, surfaces = 0;
  for (const Event& e : function) {
    samples += 2;  // a ramp adds its end, and its start where V was constant before
    surfaces += e.surface;
  }
  EXPECT_LE(nodes.size(), samples + 2 * surfaces) << what;
  ASSERT_FALSE(nodes.empty()) << what;
  EXPECT_LE(nodes.front().y, 1.0f) << what;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    EXPECT_LE(nodes[i - 1].x, nodes[i].x) << what << "node " << i;
    EXPECT_LE(nodes[i].y, nodes[i - 1].y) << what << "node " << i << " rises";
  }
  EXPECT_EQ(nodes.back().y, function.back().t) << what << "does not end exactly";
  EXPECT_GE(nodes.back().y, 0.0f) << what;
}

/// How a random function is made.
struct Kind {
  std::string name;
  int events;       ///< at most
  double surfaces;  ///< part of the events
  double gaps;      ///< part of the ramps with a constant stretch in front
  double fall;      ///< most of a ramp's fall, as part of what is left
  double start;     ///< depth of the first event
};

Function randomFunction(const Kind& kind, reference::Random& random) {
  Function function;
  double z = kind.start + random.uniform(0.0, 1.0);
  float t = 1.0f;
  const int count = random.integer(1, kind.events);
  for (int i = 0; i < count; ++i) {
    const bool surface = random.uniform(0.0, 1.0) < kind.surfaces;
    const double strength = surface ? random.uniform(0.0, 1.0) : random.uniform(0.0, kind.fall);
    t *= float(1.0 - strength * strength);
    if (random.uniform(0.0, 1.0) < 0.02) t = 0.0f;
    const bool gap = surface ? random.uniform(0.0, 1.0) < 0.8 : random.uniform(0.0, 1.0) < kind.gaps;
    if (gap) z += random.uniform(0.0, 0.3);
    const float from = float(z), to = surface ? from : float(z + random.uniform(0.001, 0.1));
    function.push_back({from, to, t, surface});
    z = to;
    if (t == 0.0f) break;
  }
  return function;
}

std::vector<Kind> kinds() {
  return {{"Smoke", 300, 0.0, 0.05, 0.3, 1.0},      {"Steep", 40, 0.0, 0.3, 1.0, 1.0},
          {"Surfaces", 30, 1.0, 1.0, 0.0, 1.0},     {"Mixed", 100, 0.2, 0.3, 0.4, 1.0},
          {"ThinLayers", 200, 0.05, 1.0, 0.2, 1.0}, {"FarAway", 60, 0.1, 0.2, 0.4, 100.0},
          {"NearlyFlat", 500, 0.0, 0.0, 0.05, 1.0}};
}

class Compression : public ::testing::TestWithParam<std::tuple<std::size_t, float>> {};

TEST_P(Compression, staysWithinTheToleranceFallsAndEndsExactly) {
  const Kind kind = kinds()[std::get<0>(GetParam())];
  const float tolerance = std::get<1>(GetParam());
  reference::Random random(std::uint32_t(17 + std::get<0>(GetParam())));
  std::vector<Function> functions;
  for (int i = 0; i < 250; ++i) functions.push_back(randomFunction(kind, random));
  const std::vector<Compressed> compressed = compress(functions, tolerance);
  for (std::size_t i = 0; i < functions.size() && !HasFailure(); ++i) {
    const std::string what = kind.name + " " + std::to_string(i) + ": ";
    expectSound(functions[i], compressed[i], what);
    expectWithin(functions[i], compressed[i], tolerance, what);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Compression,
                         ::testing::Combine(::testing::Range<std::size_t>(0, kinds().size()),
                                            ::testing::Values(0.0f, 0.001f, 0.01f, 0.1f, 0.5f)),
                         [](const auto& instance) {
                           return kinds()[std::get<0>(instance.param)].name + "Tolerance" +
                                  std::to_string(int(1000.0f * std::get<1>(instance.param)));
                         });

TEST(CompressionAlone, ofAStraightLineIsTwoNodes) {
  Function line;
  for (int i = 0; i < 100; ++i)
    line.push_back({1.0f + 0.01f * i, 1.0f + 0.01f * (i + 1), 1.0f - 0.01f * (i + 1), false});
  for (std::size_t i = 1; i < line.size(); ++i) line[i].from = line[i - 1].to;
  EXPECT_EQ(compress({line}, 0.001f).front().size(), 2u);
}

TEST(CompressionAlone, ofOneSurfaceIsOneNode) {
  const Compressed nodes = compress({{{2.0f, 2.0f, 0.25f, true}}}, 0.01f).front();
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].x, 2.0f);
  EXPECT_EQ(nodes[0].y, 0.25f);
}

TEST(CompressionAlone, ofNothingIsNothing) { EXPECT_TRUE(compress({{}}, 0.01f).front().empty()); }

TEST(CompressionAlone, savesNodesOfASmoothFunction) {
  Function smooth;
  for (int i = 0; i < 500; ++i)
    smooth.push_back({1.0f + 0.01f * i, 1.0f + 0.01f * (i + 1), float(std::exp(-0.01 * (i + 1))), false});
  EXPECT_LT(compress({smooth}, 0.01f).front().size(), 12u);
}

}  // namespace
}  // namespace cdsm::kernels
