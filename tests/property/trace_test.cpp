// SPDX-License-Identifier: Apache-2.0
// Traces: every command of the device once, on the host's clock and within the call that waited for it; steps of the
// host that lie within each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "engine/trace_json.hpp"
#include "engine_paths.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

struct TracedEngine {
  std::vector<TraceEvent> events;
  Clock::time_point begun = Clock::now();
  Engine engine{optionsWith([this](const TraceEvent& event) { events.push_back(event); })};

  static EngineOptions optionsWith(TraceSink sink) {
    EngineOptions options;
    options.fetch = "buffer";
    options.trace = std::move(sink);
    return options;
  }
  std::vector<TraceEvent> onTrack(TraceEvent::Track track) const {
    std::vector<TraceEvent> some;
    for (const TraceEvent& event : events)
      if (event.track == track) some.push_back(event);
    std::stable_sort(some.begin(), some.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    return some;
  }
};

Scene smallScene() {
  Scene scene = along(mapPath(), reference::randomScene(5), 48, 0.01f);
  scene.image.width = 40;
  scene.image.height = 30;
  return scene;
}

Clock::time_point endOf(const TraceEvent& event) {
  return event.begin + std::chrono::duration_cast<Clock::duration>(event.duration);
}

bool within(const TraceEvent& inner, const TraceEvent& outer) {
  return inner.begin >= outer.begin && endOf(inner) <= endOf(outer);
}

TEST(Trace, holdsEachCommandOfTheDeviceOnce) {
  TracedEngine traced;
  for (int frame = 0; frame < 2; ++frame) {
    traced.events.clear();
    traced.engine.render(smallScene());
    std::map<std::string, KernelTime> sums;
    for (const TraceEvent& event : traced.onTrack(TraceEvent::Track::Device)) {
      KernelTime& sum = sums[event.name];
      ++sum.launches;
      sum.milliseconds += Milliseconds(event.duration).count();
      EXPECT_NE(event.bytes > 0, event.workItems > 0) << event.name;
      EXPECT_FALSE(event.group.empty()) << event.name;
    }
    if (sums.empty()) GTEST_SKIP() << "the device keeps no times";
    const std::vector<KernelTime>& kernels = traced.engine.stats().kernels;
    EXPECT_EQ(sums.size(), kernels.size());
    for (const KernelTime& kernel : kernels) {
      EXPECT_EQ(sums[kernel.name].launches, kernel.launches) << kernel.name;
      EXPECT_NEAR(sums[kernel.name].milliseconds, kernel.milliseconds, 1e-6) << kernel.name;
    }
  }
}

TEST(Trace, putsCommandsIntoTheCallThatWaitedForThem) {
  TracedEngine traced;
  traced.engine.render(smallScene());
  const std::vector<TraceEvent> host = traced.onTrack(TraceEvent::Track::Host);
  const std::vector<TraceEvent> commands = traced.onTrack(TraceEvent::Track::Device);
  const auto frame =
      std::find_if(host.begin(), host.end(), [](const TraceEvent& event) { return event.name == "render image"; });
  ASSERT_NE(frame, host.end());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    EXPECT_TRUE(within(commands[i], *frame)) << commands[i].name;
    if (i > 0) EXPECT_GE(commands[i].begin, endOf(commands[i - 1])) << commands[i].name << ": the queue is in order";
  }
}

TEST(Trace, nestsStepsOfTheHost) {
  TracedEngine traced;
  traced.engine.render(smallScene());
  std::vector<TraceEvent> open;
  for (const TraceEvent& step : traced.onTrack(TraceEvent::Track::Host)) {
    EXPECT_GE(step.begin, traced.begun);
    while (!open.empty() && endOf(open.back()) <= step.begin) open.pop_back();
    if (!open.empty()) EXPECT_TRUE(within(step, open.back())) << step.name << " in " << open.back().name;
    open.push_back(step);
  }
  for (const char* name : {"render image", "upload objects", "prepare shadows", "plan clusters", "build map 0"})
    EXPECT_TRUE(std::any_of(traced.events.begin(), traced.events.end(), [&](const TraceEvent& event) {
      return event.name == name;
    })) << name;
}

TEST(Trace, becomesJsonThatViewersRead) {
  TracedEngine traced;
  traced.engine.render(smallScene());
  traced.engine.transmittance(smallScene(), "key", {glm::vec3(0.0f)});
  const auto json = nlohmann::json::parse(engine::traceJson(traced.engine.device(), traced.events, traced.begun));
  const double total = Milliseconds(Clock::now() - traced.begun).count() * 1000.0;
  std::size_t complete = 0;
  for (const auto& event : json.at("traceEvents")) {
    for (const char* key : {"name", "ph", "pid", "tid", "args"}) ASSERT_TRUE(event.contains(key)) << event;
    if (event.at("ph") == "M") continue;
    ASSERT_EQ(event.at("ph"), "X");
    ++complete;
    EXPECT_GE(event.at("ts").get<double>(), 0.0);
    EXPECT_GE(event.at("dur").get<double>(), 0.0);
    EXPECT_LE(event.at("ts").get<double>() + event.at("dur").get<double>(), total) << event;
  }
  EXPECT_EQ(complete, traced.events.size());
}

TEST(Trace, saysWhereTheDeviceKeepsNoTimes) {
  const DeviceDescription device;
  TraceEvent step;
  step.begin = Clock::now();
  const auto without = nlohmann::json::parse(engine::traceJson(device, {step}, step.begin));
  EXPECT_EQ(without.at("otherData").at("device_events"), "none: the device keeps no times of its commands");
  step.track = TraceEvent::Track::Device;
  EXPECT_EQ(nlohmann::json::parse(engine::traceJson(device, {step}, step.begin)).at("otherData").at("device_events"),
            "all");
}

TEST(Trace, changesNothing) {
  Engine failing(TracedEngine::optionsWith([](const TraceEvent&) { throw std::runtime_error("no room"); }));
  EXPECT_EQ(failing.render(smallScene()).pixels, engineOf("buffer").render(smallScene()).pixels);
}

}  // namespace
}  // namespace cdsm::property
