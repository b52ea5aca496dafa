// SPDX-License-Identifier: Apache-2.0
// Queries and images from and to memory of the caller's, on the host and on the device; what is refused.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "given_place.hpp"

namespace cdsm::embedding {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A spot light whose cone some of the points are outside of.
Scene narrowScene() {
  Scene scene = cloudScene();
  scene.lights.front().cutoff = 12.0f;
  return scene;
}

std::vector<float> spread(const std::vector<glm::vec3>& points, std::size_t stride) {
  std::vector<float> floats(points.size() * stride, kNaN);
  for (std::size_t i = 0; i < points.size(); ++i) std::memcpy(&floats[i * stride], &points[i], sizeof points[i]);
  return floats;
}

class DeviceQueries : public ::testing::Test {
 protected:
  Given given_;
  Engine engine_ = opencl::makeEngine(given_.place());
  std::vector<glm::vec3> points_ = somePoints(300);
  cl::Buffer values_ = given_.buffer(std::vector<float>(points_.size(), -2.0f));

  std::string says(const opencl::Points& points, cl_mem values, const std::string& light = "key") {
    return errorOf([&] { opencl::transmittance(engine_, light, points, values); });
  }
};

TEST_F(DeviceQueries, AnswerAsOnTheHost) {
  engine_.prepare(narrowScene());
  const std::vector<float> wanted = answers(engine_, points_);
  EXPECT_NE(std::count(wanted.begin(), wanted.end(), -1.0f), 0);
  for (const std::size_t stride : {3u, 4u, 7u}) {
    const cl::Buffer points = given_.buffer(spread(points_, stride));
    opencl::transmittance(engine_, "key", {points(), points_.size(), stride}, values_());
    EXPECT_EQ(given_.read<float>(values_), wanted) << stride;
    EXPECT_EQ(engine_.stats().uploadedBytes, 0u);
  }
}

TEST_F(DeviceQueries, WaitForEventsAndTellTheirEnd) {
  engine_.prepare(narrowScene());
  const std::vector<float> wanted = answers(engine_, points_);
  const cl::Buffer points = given_.buffer(spread(somePoints(300), 3));
  std::vector<float> nowhere(3 * points_.size(), 99.0f);
  given_.queue.enqueueWriteBuffer(points, CL_TRUE, 0, 4 * nowhere.size(), nowhere.data());
  const cl::UserEvent written(given_.context);
  const cl::CommandQueue second(given_.context, given_.device);
  const std::vector<cl::Event> after{written};
  const std::vector<float> right = spread(points_, 3);
  cl::Event copied;
  second.enqueueWriteBuffer(points, CL_FALSE, 0, 4 * right.size(), right.data(), &after, &copied);
  second.flush();
  cl_event done = nullptr;
  opencl::transmittance(engine_, "key", {points(), points_.size()}, values_(), {{copied()}, &done});
  cl::Event end(done);
  EXPECT_NE(end.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(), CL_COMPLETE);
  cl::UserEvent(written).setStatus(CL_COMPLETE);
  end.wait();
  EXPECT_EQ(given_.read<float>(values_), wanted);
}

TEST_F(DeviceQueries, AreRefusedWithARemedy) {
  const Given other;
  const cl::Buffer points = given_.buffer(spread(points_, 3)), foreign = other.buffer(spread(points_, 3));
  const std::size_t count = points_.size();
  EXPECT_NE(says({points(), count}, values_()).find("prepare()"), std::string::npos);
  engine_.prepare(cloudScene());
  EXPECT_NE(says({points(), count}, values_(), "sun").find("known: key"), std::string::npos);
  EXPECT_NE(says({nullptr, count}, values_()).find("null"), std::string::npos);
  EXPECT_NE(says({points(), count}, nullptr).find("null"), std::string::npos);
  EXPECT_NE(says({points(), count, 2}, values_()).find("at least 3"), std::string::npos);
  EXPECT_NE(says({points(), count, 4}, values_()).find("bytes, must have at least"), std::string::npos);
  EXPECT_NE(says({points(), count + 1}, values_()).find("at least"), std::string::npos);
  EXPECT_NE(says({points(), std::size_t(1) << 62}, values_()).find("fit no memory"), std::string::npos);
  EXPECT_NE(says({foreign(), count}, values_()).find("another context"), std::string::npos);
  EXPECT_EQ(says({nullptr, 0}, nullptr), "");
  EXPECT_EQ(says({points(), count}, values_()), "");
  EXPECT_EQ(given_.read<float>(values_), answers(cloudScene(), points_));
}

TEST_F(DeviceQueries, PointsThatAreNotFiniteAreNotLit) {
  engine_.prepare(narrowScene());
  const cl::Buffer points = given_.buffer(std::vector<float>{kNaN, 0.0f, 0.0f}),
                   value = given_.buffer(std::vector{0.0f});
  opencl::transmittance(engine_, "key", {points(), 1}, value());
  EXPECT_EQ(given_.read<float>(value), std::vector<float>{-1.0f});
}

TEST(HostQueries, AnswerAsWholeScenesDo) {
  Engine engine;
  const Scene scene = narrowScene();
  const auto points = somePoints(300);
  const std::vector<Transmittance> wanted = engine.transmittance(scene, "key", points);
  const std::vector<float> values = answers(engine, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(wanted[i].lit != 0, values[i] >= 0.0f);
    EXPECT_EQ(wanted[i].transmittance, std::max(values[i], 0.0f));
  }
}

TEST(HostQueries, AreAboutTheSceneGivenLast) {
  Engine engine;
  Scene scene = narrowScene();
  scene.shadows.clusters = 4;
  const auto points = somePoints(300);
  engine.prepare(scene);
  const std::vector<float> wanted = answers(engine, points);
  engine.render(scene);
  EXPECT_EQ(answers(engine, points), wanted) << "as good for all points as without an image";
  scene.lights.front().position.x += 0.5f;
  engine.render(scene);
  EXPECT_EQ(answers(engine, points), answers(scene, points));
}

TEST(HostQueries, AreRefusedWithARemedy) {
  Engine engine;
  std::vector<glm::vec3> points = somePoints(40);
  std::vector<float> values(points.size());
  const auto says = [&](const glm::vec3* at, std::size_t count, float* to) {
    return errorOf([&] { engine.transmittance("key", at, count, to); });
  };
  EXPECT_NE(says(points.data(), 1, values.data()).find("prepare()"), std::string::npos);
  engine.prepare(cloudScene());
  EXPECT_NE(says(nullptr, 1, values.data()).find("points is null"), std::string::npos);
  EXPECT_NE(says(points.data(), 1, nullptr).find("values is null"), std::string::npos);
  EXPECT_EQ(says(nullptr, 0, nullptr), "");
  points[17].y = kNaN;
  EXPECT_NE(says(points.data(), points.size(), values.data()).find("point 17 is not finite"), std::string::npos);
  points[17].y = INFINITY;
  EXPECT_NE(says(points.data(), points.size(), values.data()).find("point 17 is not finite"), std::string::npos);
  points[17].y = 0.0f;
  EXPECT_EQ(says(points.data(), points.size(), values.data()), "");
  EXPECT_EQ(values, answers(cloudScene(), points));
}

TEST(HostQueries, NeedASceneAfterOneThatFailed) {
  Engine engine;
  engine.prepare(cloudScene());
  Scene wrong = cloudScene();
  wrong.shadows.technique = "magic";
  EXPECT_NE(errorOf([&] { engine.prepare(wrong); }).find("magic"), std::string::npos);
  EXPECT_NE(errorOf([&] { answers(engine, somePoints(3)); }).find("prepare()"), std::string::npos);
  engine.prepare(cloudScene());
  wrong = cloudScene();
  wrong.lights.front().cutoff = -1.0f;
  EXPECT_NE(errorOf([&] { engine.render(wrong); }).find("cutoff"), std::string::npos);
  EXPECT_NE(errorOf([&] { answers(engine, somePoints(3)); }).find("prepare()"), std::string::npos);
  engine.prepare(cloudScene());
  EXPECT_EQ(answers(engine, somePoints(30)), answers(cloudScene(), somePoints(30)));
  engine.drop();
  EXPECT_NE(errorOf([&] { answers(engine, somePoints(3)); }).find("prepare()"), std::string::npos);
}

TEST(Warnings, GoToTheirCallback) {
  std::vector<std::string> told;
  EngineOptions options;
  options.warning = [&](const std::string& warning) { told.push_back(warning); };
  Engine engine(options);
  Scene scene = cloudScene();
  engine.prepare(scene);
  EXPECT_TRUE(told.empty());
  scene.shadows.memoryLimitMb = 0.9f * float(engine.stats().memory.bytesReserved) / 1048576.0f;
  scene.shadows.onOverflow = "coarsen";
  engine.prepare(scene);
  EXPECT_EQ(told, engine.stats().warnings);
  EXPECT_EQ(told.size(), 1u);
}

TEST(Images, GoToTheCallersMemory) {
  const Given given;
  Engine engine = opencl::makeEngine(given.place());
  Scene scene = cloudScene();
  scene.image.supersampling = 2;
  const Image wanted = engine.render(scene);
  std::vector<glm::vec4> pixels(wanted.pixels.size());
  engine.render(scene, pixels.data());
  EXPECT_EQ(pixels, wanted.pixels);
  const cl::Buffer buffer = given.buffer(std::vector<glm::vec4>(pixels.size()));
  opencl::render(engine, scene, buffer());
  EXPECT_EQ(given.read<glm::vec4>(buffer), wanted.pixels);
  const cl::Image2D image(given.context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, CL_FLOAT), 24, 16);
  opencl::render(engine, scene, image());
  std::fill(pixels.begin(), pixels.end(), glm::vec4(0.0f));
  given.queue.enqueueReadImage(image, CL_TRUE, {0, 0, 0}, {24, 16, 1}, 0, 0, pixels.data());
  EXPECT_EQ(pixels, wanted.pixels);
}

TEST(Images, AreRefusedWhereTheyDoNotFit) {
  const Given given, other;
  Engine engine = opencl::makeEngine(given.place());
  const Scene scene = cloudScene();
  const auto says = [&](cl_mem target) { return errorOf([&] { opencl::render(engine, scene, target); }); };
  const cl::Buffer small = given.buffer(std::vector<glm::vec4>(24 * 15)),
                   foreign = other.buffer(std::vector<glm::vec4>(384));
  const cl::Image2D other8(given.context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, CL_UNORM_INT8), 24, 16);
  const cl::Image2D wide(given.context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, CL_FLOAT), 25, 16);
  EXPECT_NE(errorOf([&] { engine.render(scene, static_cast<glm::vec4*>(nullptr)); }).find("null"), std::string::npos);
  EXPECT_NE(says(nullptr).find("null"), std::string::npos);
  EXPECT_NE(says(small()).find("must have 6144"), std::string::npos);
  EXPECT_NE(says(foreign()).find("another context"), std::string::npos);
  EXPECT_NE(says(other8()).find("CL_FLOAT"), std::string::npos);
  EXPECT_NE(says(wide()).find("24 x 16"), std::string::npos);
  EXPECT_NO_THROW(engine.render(scene));
}

}  // namespace
}  // namespace cdsm::embedding
