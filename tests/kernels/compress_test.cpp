// SPDX-License-Identifier: Apache-2.0
// The compression of visibility functions alone: random falling ramps and steps through build/compress.clh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel_test.hpp"
#include "memory/node_format.hpp"
#include "reference/test_scenes.hpp"
#include "shared/types.h"

namespace cdsm::kernels {
namespace {

using shared::float2;
using shared::float4;
using Nodes = device::Buffer<float2>;

/// A memory strategy of one plain array per function.
const char* const kMemory = R"(
#include CDSM_NODE_FORMAT
typedef struct NodeWriter { __global Node* nodes; uint capacity, count; } NodeWriter;
void writeNode(NodeWriter* w, Node node) { if (w->count < w->capacity) w->nodes[w->count] = node; ++w->count; }
)";

/// An item per function. Events: (from, to, t, 0) a ramp, (z, z, t, 1) a surface; firsts[i] .. firsts[i + 1].
const char* const kText = R"(
#include "common/math.clh"
#include "build/visibility.clh"
__kernel void compress(uint functions, float tolerance, uint capacity, DepthScale scale, __global const float4* events,
                       __global const uint* firsts, __global float2* nodes, __global uint* counts) {
  uint i = (uint)get_global_id(0);
  if (i >= functions) return;
  NodeWriter writer;
  writer.nodes = nodes + i * capacity;
  writer.capacity = capacity;
  writer.count = 0;
  VisibilityBuilder b = beginVisibility(&writer, scale);
  b.tolerance = tolerance;
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

/// `format`: "float32", or "unorm16" with depths that count steps of `scale`.
std::vector<Compressed> compress(const std::vector<Function>& functions, float tolerance,
                                 const std::string& format = "float32", const float2& scale = {0.0f, 1.0f}) {
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
  const cl::Program& program = testProgram(device, kText,
                                           {{"CDSM_MEMORY", "\"test/memory.clh\""},
                                            {"CDSM_BATCH", "4"},
                                            memory::nodeFormatDefine(memory::nodeFormat(format, "grey"))},
                                           {{"test/memory.clh", kMemory}});
  device::Kernel<std::uint32_t, float, std::uint32_t, float2, device::Buffer<float4>, device::Buffer<std::uint32_t>,
                 Nodes, device::Buffer<std::uint32_t>>
      kernel(device, program, "compress");
  kernel({"compress", {functions.size()}, {kGroup}}, std::uint32_t(functions.size()), tolerance,
         std::uint32_t(capacity), scale, in, starts, nodes, counts);
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

/// `ends`: of a ramp, each of which may become so many nodes.
void expectSound(const Function& function, const Compressed& nodes, const std::string& what, std::size_t ends = 2) {
  std::size_t samples = 2, surfaces = 0;
  for (const Event& e : function) {
    samples += ends;  // a ramp adds its end, and its start where V was constant before
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

/// V just in front of z, or just behind it.
double exactAt(const Function& function, double z, bool behind) {
  double t = 1.0;
  for (const Event& e : function) {
    const bool before = behind ? e.from <= z : e.from < z;
    if (!before) break;
    const bool passed = e.surface || e.to <= z;
    t = passed ? e.t : t + (e.t - t) * ((z - e.from) / (double(e.to) - e.from));
  }
  return t;
}

/// Of a cell between two depths that a node can have the compression knows V at the ends: V' is between these, but for
/// the tolerance. At the ends themselves that is |V' - V| <= tolerance, but for surfaces in the cell.
void expectWithinCells(const Function& function, const Compressed& nodes, float2 scale, double tolerance,
                       const std::string& what) {
  const double first = std::floor((double(function.front().from) - scale.x) * scale.y);
  const double last = std::ceil((double(function.back().to) - scale.x) * scale.y);
  for (double cell = std::max(first - 1.0, 0.0); cell <= last; ++cell) {
    // stored depths are of single precision: of a surface at the end of a cell they say on which side it is
    const double slack = 0.02, near = scale.x + (cell - slack) / scale.y,
                 far = scale.x + (cell + 1.0 + slack) / scale.y;
    const double high = exactAt(function, near, false) + tolerance, low = exactAt(function, far, true) - tolerance;
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const double found = valueAt(nodes, cell + part, part == 0.0);
      ASSERT_LE(found, high + kRounding) << what << "cell " << cell << " + " << part;
      ASSERT_GE(found, low - kRounding) << what << "cell " << cell << " + " << part;
    }
  }
}

/// How far V falls in the cell of z and its neighbours.
double steepnessAt(const Function& function, double z, float2 scale) {
  return exactAt(function, z - 1.0 / scale.y, false) - exactAt(function, z + 1.0 / scale.y, true);
}

/// Where V falls by no more than `cellShare` of the tolerance between two depths that a node can have, all of |V' - V|
/// is within it.
int expectWithinWhereEven(const Function& function, const Compressed& nodes, float2 scale, double tolerance,
                          double cellShare, const std::string& what) {
  int checked = 0;
  for (const Event& e : function)
    for (const double z : {double(e.from), 0.5 * (double(e.from) + e.to), double(e.to)}) {
      if (steepnessAt(function, z, scale) > cellShare * tolerance) continue;
      ++checked;
      EXPECT_NEAR(valueAt(nodes, (z - scale.x) * scale.y, false), exactAt(function, z, false), tolerance + kRounding)
          << what << z;
    }
  return checked;
}

class CompressionToSteps : public ::testing::TestWithParam<std::tuple<std::size_t, float, float>> {};

TEST_P(CompressionToSteps, staysWithinTheToleranceFallsAndEndsExactly) {
  const auto [number, tolerance, step] = GetParam();
  const Kind kind = kinds()[number];
  const memory::NodeFormat& format = memory::nodeFormat("unorm16", "grey");
  const float2 scale{0.5f * float(kind.start), 1.0f / step};
  reference::Random random(std::uint32_t(91 + number));
  std::vector<Function> functions;
  for (int i = 0; i < 100; ++i) functions.push_back(randomFunction(kind, random));
  const float forLines = format.compressionTolerance(tolerance);
  const std::vector<Compressed> compressed = compress(functions, forLines, "unorm16", scale);
  int even = 0;
  for (std::size_t i = 0; i < functions.size() && !HasFailure(); ++i) {
    const std::string what = kind.name + " " + std::to_string(i) + ": ";
    expectSound(functions[i], compressed[i], what, 4);  // on both sides of each end
    for (const float2& node : compressed[i]) ASSERT_EQ(node.x, std::floor(node.x)) << what << "between two steps";
    expectWithinCells(functions[i], compressed[i], scale, double(forLines), what);
    even += expectWithinWhereEven(functions[i], compressed[i], scale, tolerance, double(format.cellShare), what);
  }
  if (step < 1e-3f && tolerance >= 0.1f && kind.surfaces < 1.0) EXPECT_GT(even, 100) << "nothing was even";
}

INSTANTIATE_TEST_SUITE_P(Kinds, CompressionToSteps,
                         ::testing::Combine(::testing::Range<std::size_t>(0, kinds().size()),
                                            ::testing::Values(0.001f, 0.01f, 0.1f),
                                            ::testing::Values(0.0005f, 0.01f, 0.07f)),
                         [](const auto& instance) {
                           return kinds()[std::get<0>(instance.param)].name + "Tolerance" +
                                  std::to_string(int(1000.0f * std::get<1>(instance.param))) + "Step" +
                                  std::to_string(int(10000.0f * std::get<2>(instance.param)));
                         });

TEST(StoredNodes, of16BitsAreRoundedAndKeepBothEnds) {
  const char* const text = R"(
#include CDSM_NODE_FORMAT
__kernel void throughMemory(uint count, __global const Node* nodes, __global StoredNode* pool, __global Node* back) {
  uint i = (uint)get_global_id(0);
  if (i >= count) return;
  storeNode(pool, i, nodes[i]);
  back[i] = loadNode(pool, i);
}
)";
  std::vector<float2> nodes{{0.0f, 1.0f}, {65535.0f, 0.0f}, {65536.0f, 1.0001f}};  // what is too great stays at the end
  reference::Random random(5);
  for (int i = 0; i < 1000; ++i) nodes.push_back({float(random.integer(0, 65535)), float(random.uniform(0.0, 1.0))});
  device::Device& device = deviceOf();
  const memory::NodeFormat& format = memory::nodeFormat("unorm16", "grey");
  const Nodes in = Nodes::fromHost(device, nodes, "nodes");
  Nodes out(device, nodes.size(), "nodes read back");
  device::Buffer<std::uint32_t> pool(device, nodes.size() * format.words, "pool");
  device::Kernel<std::uint32_t, Nodes, device::Buffer<std::uint32_t>, Nodes> kernel(
      device, testProgram(device, text, {memory::nodeFormatDefine(format)}), "throughMemory");
  kernel({"through memory", {nodes.size()}, {kGroup}}, std::uint32_t(nodes.size()), in, pool, out);
  const std::vector<float2> back = out.download();
  EXPECT_EQ(back[0].y, 1.0f);
  EXPECT_EQ(back[1].y, 0.0f);
  EXPECT_EQ(back[2].x, 65535.0f);
  EXPECT_EQ(back[2].y, 1.0f);
  for (std::size_t i = 3; i < nodes.size(); ++i) {
    EXPECT_EQ(back[i].x, nodes[i].x) << i;
    EXPECT_NEAR(back[i].y, nodes[i].y, format.valueError + 1e-7f) << i;
  }
}

TEST(CompressionToStepsAlone, keepsSurfacesUprightAndBehindThemselves) {
  const Function two{{2.25f, 2.25f, 0.75f, true}, {2.75f, 2.75f, 0.5f, true}, {4.0f, 4.0f, 0.25f, true}};
  const Compressed nodes = compress({two}, 0.01f, "unorm16", {0.0f, 1.0f}).front();
  const std::vector<float2> expected{{3.0f, 0.5f}, {4.0f, 0.5f}, {4.0f, 0.25f}};
  ASSERT_EQ(nodes.size(), expected.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes[i].x, expected[i].x) << i;
    EXPECT_EQ(nodes[i].y, expected[i].y) << i;
  }
}

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
