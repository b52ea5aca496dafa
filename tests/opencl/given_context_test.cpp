// SPDX-License-Identifier: Apache-2.0
// Engines in a context that is there already, several of them at once, in several threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "given_place.hpp"

namespace cdsm::embedding {
namespace {

cl_uint references(const Given& given) {
  return given.context.getInfo<CL_CONTEXT_REFERENCE_COUNT>() + given.queue.getInfo<CL_QUEUE_REFERENCE_COUNT>();
}

bool anyShadow(const std::vector<float>& values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return v > 0.01f && v < 0.99f; });
}

TEST(GivenContext, AnswersAsAnEngineOfItsOwn) {
  const Given given;
  const Scene scene = cloudScene();
  const auto points = somePoints(300);
  const std::vector<float> wanted = answers(scene, points);
  ASSERT_TRUE(anyShadow(wanted));
  Engine engine = opencl::makeEngine(given.place());
  engine.prepare(scene);
  EXPECT_EQ(answers(engine, points), wanted);
  const opencl::Place place = opencl::placeOf(engine);
  EXPECT_EQ(place.context, given.context());
  EXPECT_EQ(place.device, given.device());
  EXPECT_EQ(place.queue, given.queue());
}

TEST(GivenContext, IsGivenBack) {
  const Given given;
  const cl_uint before = references(given);
  {
    Engine engine = opencl::makeEngine(given.place());
    engine.render(cloudScene());
    EXPECT_GT(references(given), before);
  }
  EXPECT_EQ(references(given), before);
}

TEST(GivenContext, OutlivesTheEmbeddersReferences) {
  const auto points = somePoints(50);
  std::unique_ptr<Engine> engine;
  {
    const Given given;
    engine = std::make_unique<Engine>(opencl::makeEngine(given.place()));
  }
  engine->prepare(cloudScene());
  EXPECT_EQ(answers(*engine, points), answers(cloudScene(), points));
}

TEST(GivenContext, QueueMayKeepNoTimes) {
  const Given given(0);
  Engine engine = opencl::makeEngine(given.place());
  engine.render(cloudScene());
  EXPECT_FALSE(engine.stats().deviceTimes);
  EXPECT_EQ(engine.stats().renderMs, 0.0);
  EXPECT_GT(engine.stats().totalMs, 0.0);
  EXPECT_FALSE(engine.stats().kernels.empty());
}

TEST(GivenContext, QueueMayBeLeftOut) {
  const Given given;
  Engine engine = opencl::makeEngine({given.context(), given.device(), nullptr});
  engine.render(cloudScene());
  EXPECT_TRUE(engine.stats().deviceTimes);
  EXPECT_NE(opencl::placeOf(engine).queue, given.queue());
}

TEST(GivenContext, RefusesWhatDoesNotBelongTogether) {
  const Given given, other;
  const auto says = [](const opencl::Place& place, const EngineOptions& options = {}) {
    return errorOf([&] { opencl::makeEngine(place, options); });
  };
  EXPECT_NE(says({}).find("is null"), std::string::npos);
  EXPECT_NE(says({given.context(), nullptr, given.queue()}).find("is null"), std::string::npos);
  EXPECT_NE(says({given.context(), given.device(), other.queue()}).find("not of the given context"), std::string::npos);
  EngineOptions named;
  named.device = "0:0";
  EXPECT_NE(says(given.place(), named).find("leave the name empty"), std::string::npos);
}

TEST(GivenContext, RefusesAQueueOutOfOrder) {
  const cl::Device device = chosenDevice();
  const auto can = device.getInfo<CL_DEVICE_QUEUE_PROPERTIES>();
  if (!(can & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE)) GTEST_SKIP() << "the device has no such queues";
  const Given given(CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  EXPECT_NE(errorOf([&] { opencl::makeEngine(given.place()); }).find("out of order"), std::string::npos);
}

TEST(SeveralEngines, WorkSideBySide) {
  const Given given;
  const auto points = somePoints(200);
  Scene dark = cloudScene(), bright = dark;
  bright.volumes.front().shadow.casts = false;
  Engine a = opencl::makeEngine(given.place()), b = opencl::makeEngine(given.place()), c;
  a.prepare(dark);
  b.prepare(bright);
  c.prepare(dark);
  const std::vector<float> fromA = answers(a, points), fromB = answers(b, points);
  EXPECT_NE(fromA, fromB);
  EXPECT_EQ(fromA, answers(c, points));
  EXPECT_EQ(fromA, answers(a, points));
}

/// An image and answers by an engine of its own, with a cloud of its own.
std::vector<float> workOf(int number, const opencl::Place* place) {
  Scene scene = cloudScene();
  scene.volumes.front().data = std::make_shared<VolumeData>(cloud(VoxelType::UInt8, float(number)));
  scene.shadows.memory = number % 2 ? "exact" : "chunked";
  Engine engine = place ? opencl::makeEngine(*place) : Engine();
  const Image image = engine.render(scene);
  std::vector<float> values = answers(engine, somePoints(200));
  for (const glm::vec4& pixel : image.pixels) values.insert(values.end(), {pixel.x, pixel.y, pixel.z, pixel.w});
  return values;
}

TEST(SeveralEngines, WorkInSeveralThreads) {
  constexpr int kThreads = 4;
  const Given given;
  const opencl::Place shared{given.context(), given.device(), nullptr};
  std::vector<std::vector<float>> wanted(kThreads), got(kThreads);
  for (int i = 0; i < kThreads; ++i) wanted[std::size_t(i)] = workOf(i, nullptr);
  EXPECT_NE(wanted[0], wanted[1]);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i)
    threads.emplace_back([&, i] { got[std::size_t(i)] = workOf(i, i < kThreads / 2 ? nullptr : &shared); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(got, wanted);
}

TEST(SeveralEngines, MovedFromIsRefused) {
  Engine engine, other = std::move(engine);
  EXPECT_NE(errorOf([&] { engine.render(cloudScene()); }).find("moved"), std::string::npos);
  EXPECT_NO_THROW(other.render(cloudScene()));
}

}  // namespace
}  // namespace cdsm::embedding
