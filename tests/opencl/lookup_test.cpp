// SPDX-License-Identifier: Apache-2.0
// Shadows asked for in a kernel of the embedder's own: the numbers of the query service, bit by bit.
#include <gtest/gtest.h>

#include <cstring>

#include "given_place.hpp"

namespace cdsm::embedding {
namespace {

const char* const kEmbeddersKernels = R"(
__kernel void ask(__global const float4* points, uint count, uint light, __global float* values, CDSM_LOOKUP_PARAMS) {
  size_t i = get_global_id(0);
  if (i >= count) return;
  float3 p = points[i].xyz;
  values[i] = cdsmLit(light, p, CDSM_LOOKUP_ARGS) ? cdsmTransmittance(light, p, CDSM_LOOKUP_ARGS) : -1.0f;
}
)";

const char* const kEmbeddersColors = R"(
__kernel void ask(__global const float4* points, uint count, uint light, __global float* values, CDSM_LOOKUP_PARAMS) {
  size_t i = get_global_id(0);
  if (i >= count) return;
  float3 p = points[i].xyz, t = (float3)(-1.0f);
  if (cdsmLit(light, p, CDSM_LOOKUP_ARGS)) t = cdsmTransmittance(light, p, CDSM_LOOKUP_ARGS);
  vstore3(t, i, values);
}
)";

/// What the embedder's kernel says of the points.
std::vector<float> ask(const Given& given, const opencl::Lookup& lookup, const std::string& light,
                       const std::vector<glm::vec3>& points, std::size_t channels = 1) {
  const char* const kernels = channels == 1 ? kEmbeddersKernels : kEmbeddersColors;
  const cl::Program program(given.context, cl::Program::Sources{lookup.source(), kernels});
  program.build(given.device, lookup.buildOptions().c_str());
  cl::Kernel kernel(program, "ask");
  std::vector<glm::vec4> padded;
  for (const glm::vec3& p : points) padded.emplace_back(p, 0.0f);
  const cl::Buffer in = given.buffer(padded), out = given.buffer(std::vector<float>(channels * points.size(), -2.0f));
  kernel.setArg(0, in);
  kernel.setArg(1, cl_uint(points.size()));
  kernel.setArg(2, cl_uint(lookup.light(light)));
  kernel.setArg(3, out);
  EXPECT_EQ(lookup.setArguments(kernel(), 4), kernel.getInfo<CL_KERNEL_NUM_ARGS>());
  given.queue.enqueueNDRangeKernel(kernel, cl::NullRange, (points.size() + 63) / 64 * 64, 64);
  return given.read<float>(out);
}

Scene litTwice(const std::string& technique, const std::string& memory) {
  Scene scene = cloudScene();
  scene.shadows.technique = technique;
  scene.shadows.memory = memory;
  scene.shadows.clusters = memory == "chunked" ? 2 : 1;
  scene.lights.front().cutoff = 12.0f;
  Light lamp = scene.lights.front();
  lamp.name = "lamp";
  lamp.type = LightType::Omni;
  lamp.position = {1.0f, 1.5f, 0.5f};
  scene.lights.push_back(lamp);
  return scene;
}

void expectSameBits(const std::string& technique, const std::string& memory, const std::string& fetch,
                    const std::string& transmittance = "grey") {
  const Given given;
  EngineOptions options;
  options.fetch = fetch;
  Engine engine = opencl::makeEngine(given.place(), options);
  Scene scene = litTwice(technique, memory);
  scene.shadows.transmittance = transmittance;
  for (Volume& volume : scene.volumes) volume.transfer.transmission = volume.transfer.color;
  engine.prepare(scene);
  const opencl::Lookup lookup = opencl::lookup(engine);
  const auto points = somePoints(500);
  for (const char* light : {"key", "lamp"}) {
    std::vector<float> wanted(engine.channels() * points.size());
    engine.transmittance(light, points.data(), points.size(), wanted.data());
    const std::vector<float> got = ask(given, lookup, light, points, engine.channels());
    EXPECT_EQ(std::memcmp(got.data(), wanted.data(), 4 * wanted.size()), 0)
        << technique << ' ' << memory << ' ' << fetch << ' ' << light;
  }
}

TEST(EmbeddersKernel, SeesTheBitsOfTheQueryService) {
  for (const char* memory : {"chunked", "atlas", "exact", "tiled", "fixed"})
    expectSameBits("deep-shadow-map", memory, "buffer");
  for (const char* technique : {"none", "shadow-map", "shadow-rays"}) expectSameBits(technique, "exact", "buffer");
}

TEST(EmbeddersKernel, SeesColors) {
  for (const char* technique : {"none", "shadow-rays", "deep-shadow-map", "stochastic"})
    expectSameBits(technique, "exact", "buffer", "rgb");
}

TEST(EmbeddersKernel, SeesThemInImages) {
  if (!chosenDevice().getInfo<CL_DEVICE_IMAGE_SUPPORT>()) GTEST_SKIP() << "the device has no images";
  expectSameBits("deep-shadow-map", "exact", "image");
}

TEST(EmbeddersKernel, KeepsItsProgramWhileKindsStay) {
  Engine engine;
  Scene scene = litTwice("deep-shadow-map", "exact");
  engine.prepare(scene);
  const std::string before = opencl::lookup(engine).source();
  scene.lights.front().position.x += 0.1f;
  scene.meshes.front().worldFromObject[3].x += 0.1f;
  engine.prepare(scene);
  EXPECT_EQ(opencl::lookup(engine).source(), before);
  scene.shadows.memory = "tiled";
  engine.prepare(scene);
  EXPECT_NE(opencl::lookup(engine).source(), before);
}

TEST(EmbeddersKernel, OutlivesTheEngine) {
  const Given given;
  const auto points = somePoints(100);
  std::unique_ptr<opencl::Lookup> lookup;
  {
    Engine engine = opencl::makeEngine(given.place());
    engine.prepare(cloudScene());
    lookup = std::make_unique<opencl::Lookup>(opencl::lookup(engine));
  }
  EXPECT_EQ(ask(given, *lookup, "key", points), answers(cloudScene(), points));
}

TEST(EmbeddersKernel, IsRefusedWithARemedy) {
  const Given given;
  Engine engine = opencl::makeEngine(given.place());
  EXPECT_NE(errorOf([&] { opencl::lookup(engine); }).find("prepare()"), std::string::npos);
  engine.prepare(cloudScene());
  const opencl::Lookup lookup = opencl::lookup(engine);
  EXPECT_NE(errorOf([&] { lookup.light("sun"); }).find("known: key"), std::string::npos);
  EXPECT_NE(errorOf([&] { lookup.setArguments(nullptr, 0); }).find("null"), std::string::npos);
  const cl::Program program(given.context, "__kernel void other(int a, int b) {}", true);
  cl::Kernel other(program, "other");
  EXPECT_NE(errorOf([&] { lookup.setArguments(other(), 1); }).find("CDSM_LOOKUP_PARAMS"), std::string::npos);
}

}  // namespace
}  // namespace cdsm::embedding
