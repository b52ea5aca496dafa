// SPDX-License-Identifier: Apache-2.0
// Builds programs. In: joined text; out: a cl::Program from a cache or from source, or the compiler's first errors.
#include "device/program.hpp"

#include <sstream>
#include <vector>

#include "device/binary_cache.hpp"
#include "device/cl_error.hpp"
#include "device/device.hpp"
#include "device/host_step.hpp"

namespace cdsm::device {
namespace {

constexpr int kErrorLinesShown = 3;

/// All that a binary depends on. Platforms change their compiler with the platform version.
std::string programKey(const cl::Device& device, const std::string& text) {
  const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>());
  return platform.getInfo<CL_PLATFORM_NAME>() + '\n' + platform.getInfo<CL_PLATFORM_VERSION>() + '\n' +
         device.getInfo<CL_DEVICE_NAME>() + '\n' + device.getInfo<CL_DRIVER_VERSION>() + '\n' + kBuildOptions + '\n' +
         text;
}

/// The first lines of the log that tell of errors, on one line; the log's first lines when none does.
std::string firstErrors(const std::string& log) {
  std::string errors;
  std::string others;
  int errorCount = 0;
  int otherCount = 0;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const bool isError = line.find("error:") != std::string::npos;
    std::string& target = isError ? errors : others;
    int& count = isError ? errorCount : otherCount;
    if (line.empty() || line == std::string(1, '\0') || count++ >= kErrorLinesShown) continue;
    target += (target.empty() ? "" : "; ") + line;
  }
  if (!errors.empty()) return errors;
  return others.empty() ? "the compiler says nothing" : others;
}

std::string buildLog(const cl::Program& program, const cl::Device& device) {
  try {
    return program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
  } catch (const cl::Error&) {
    return "";
  }
}

bool isBuilt(const cl::Program& program, const cl::Device& device) {
  return program.getBuildInfo<CL_PROGRAM_BUILD_STATUS>(device) == CL_BUILD_SUCCESS;
}

/// Empty where the implementation gives none.
std::string binaryOf(const cl::Program& program) {
  try {
    const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    if (binaries.size() != 1) return {};
    return std::string(binaries[0].begin(), binaries[0].end());
  } catch (const cl::Error&) {
    return {};
  }
}

}  // namespace

const cl::Program& ProgramCache::get(const ProgramSource& source) {
  const std::string text = joinSource(source);
  const std::string doing = "program " + source.entry;
  const std::string key = guarded(doing, [&] { return programKey(device_.handle(), text); });
  const auto known = programs_.find(key);
  if (known != programs_.end()) {
    ++counts_.memoryHits;
    return known->second;
  }
  const HostStep step(device_.profiler().trace(), "make " + doing);
  cl::Program program = guarded(doing, [&] { return make(source.entry, text, key); });
  return programs_.emplace(key, std::move(program)).first->second;
}

cl::Program ProgramCache::make(const std::string& entry, const std::string& text, const std::string& key) {
  cl::Program program;
  if (buildFromBinary(loadBinary(key), program)) {
    ++counts_.diskHits;
    return program;
  }
  program = buildFromSource(entry, text);
  ++counts_.builds;
  if (canStoreBinaries()) storeBinary(key, binaryOf(program));
  return program;
}

cl::Program ProgramCache::buildFromSource(const std::string& entry, const std::string& text) {
  cl::Program program(device_.context(), text);
  try {
    program.build(device_.handle(), kBuildOptions);
  } catch (const cl::Error& error) {
    throw DeviceError("program " + entry + " does not build (" + clErrorName(error.err()) +
                      "): " + firstErrors(buildLog(program, device_.handle())));
  }
  if (isBuilt(program, device_.handle())) return program;
  throw DeviceError("program " + entry + " does not build: " + firstErrors(buildLog(program, device_.handle())));
}

bool ProgramCache::buildFromBinary(const std::string& binary, cl::Program& program) {
  if (binary.empty()) return false;
  try {
    const cl::Program::Binaries binaries{std::vector<unsigned char>(binary.begin(), binary.end())};
    program = cl::Program(device_.context(), {device_.handle()}, binaries);
    program.build(device_.handle(), kBuildOptions);
    return isBuilt(program, device_.handle());
  } catch (const cl::Error&) {
    return false;  // an older driver's, say: the source is at hand
  }
}

}  // namespace cdsm::device
