// SPDX-License-Identifier: Apache-2.0
#include "engine/trace_json.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace cdsm::engine {

namespace {

using Json = nlohmann::ordered_json;
using Microseconds = std::chrono::duration<double, std::micro>;

constexpr int kProcess = 1;
constexpr int kHostThread = 1, kDeviceThread = 2;

bool ofDevice(const TraceEvent& event) { return event.track == TraceEvent::Track::Device; }

Json nameJson(const char* what, int thread, const std::string& name) {
  return {{"name", what}, {"ph", "M"}, {"pid", kProcess}, {"tid", thread}, {"args", {{"name", name}}}};
}

Json argumentsJson(const TraceEvent& event) {
  Json arguments = Json::object();
  if (event.bytes > 0) arguments["bytes"] = event.bytes;
  if (event.workItems > 0) arguments["work_items"] = event.workItems;
  return arguments;
}

Json eventJson(const TraceEvent& event, std::chrono::steady_clock::time_point origin) {
  return {{"name", event.name},
          {"cat", ofDevice(event) ? event.group : "host"},
          {"ph", "X"},
          {"ts", Microseconds(event.begin - origin).count()},
          {"dur", Microseconds(event.duration).count()},
          {"pid", kProcess},
          {"tid", ofDevice(event) ? kDeviceThread : kHostThread},
          {"args", argumentsJson(event)}};
}

}  // namespace

std::string traceJson(const DeviceDescription& device, const std::vector<TraceEvent>& events,
                      std::chrono::steady_clock::time_point origin) {
  const bool timed = std::any_of(events.begin(), events.end(), ofDevice);
  Json list = Json::array();
  list.push_back(nameJson("process_name", kHostThread, "cdsm"));
  list.push_back(nameJson("thread_name", kHostThread, "host"));
  list.push_back(nameJson("thread_name", kDeviceThread,
                          "device " + device.name + (timed ? "" : " (keeps no times of its commands)")));
  for (const TraceEvent& event : events) list.push_back(eventJson(event, origin));
  Json other = {{"device", device.name}, {"platform", device.platform}, {"version", device.version}};
  other["device_events"] = timed ? "all" : "none: the device keeps no times of its commands";
  const Json trace = {{"traceEvents", list}, {"displayTimeUnit", "ms"}, {"otherData", other}};
  return trace.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cdsm::engine
