// SPDX-License-Identifier: Apache-2.0
// Joining of kernel files, compile errors and the program cache, on the default device with generated files alone.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "device/buffer.hpp"
#include "device/device.hpp"
#include "device/kernel.hpp"
#include "device/program.hpp"

namespace cdsm::device {
namespace {

namespace fs = std::filesystem;

/// Sets an environment variable and puts the old value back.
class ScopedEnvironment {
 public:
  ScopedEnvironment(const char* name, const std::string& value) : name_(name) {
    if (const char* old = getenv(name)) {
      old_ = old;
      had_ = true;
    }
    setenv(name, value.c_str(), 1);
  }
  ~ScopedEnvironment() {
    if (had_) {
      setenv(name_, old_.c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  ScopedEnvironment(const ScopedEnvironment&) = delete;
  ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

 private:
  const char* name_;
  std::string old_;
  bool had_ = false;
};

/// A folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "cdsm-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ProgramSource constantProgram(int value) {
  ProgramSource source{"test/constant.cl", {{"VALUE", std::to_string(value)}}, {}};
  source.generated["test/constant.cl"] =
      "kernel void writeConstant(global int* out) { if (get_global_id(0) == 0) out[0] = VALUE; }\n";
  return source;
}

int runConstant(Device& device, const cl::Program& program) {
  Buffer<int> out(device, 1, "out");
  Kernel<Buffer<int>> kernel(device, program, "writeConstant");
  kernel({"write constant", cl::NDRange(1), cl::NDRange(1)}, out);
  return out.read(0);
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void overwrite(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

TEST(JoinSource, putsEachFileInOnceAndMarksLines) {
  ProgramSource source{"test/a.cl", {}, {}};
  source.generated["test/a.cl"] = "#include \"test/b.clh\"\n#include \"test/c.clh\"\nint a;\n";
  source.generated["test/b.clh"] = "#pragma once\n#include \"test/c.clh\"\nint b;\n";
  source.generated["test/c.clh"] = "int c;\n";
  EXPECT_EQ(joinSource(source),
            "#line 1 \"kernels/test/a.cl\"\n"
            "#line 1 \"kernels/test/b.clh\"\n\n"
            "#line 1 \"kernels/test/c.clh\"\nint c;\n"
            "#line 3 \"kernels/test/b.clh\"\nint b;\n"
            "#line 2 \"kernels/test/a.cl\"\n"
            "#line 3 \"kernels/test/a.cl\"\nint a;\n");
}

TEST(JoinSource, resolvesNamedIncludesAndWritesOtherDefines) {
  ProgramSource source{"test/a.cl", {{"CDSM_MEMORY", "\"test/m.clh\""}, {"COUNT", "3"}, {"FLAG", ""}}, {}};
  source.generated["test/a.cl"] = "#include CDSM_MEMORY  // the strategy\n#include <stddef.h>\n";
  source.generated["test/m.clh"] = "int m;\n";
  EXPECT_EQ(joinSource(source),
            "#define COUNT 3\n#define FLAG 1\n"
            "#line 1 \"kernels/test/a.cl\"\n#line 1 \"kernels/test/m.clh\"\nint m;\n"
            "#line 2 \"kernels/test/a.cl\"\n#include <stddef.h>\n");
}

TEST(JoinSource, namesFileAndLineOfAMissingInclude) {
  ProgramSource source{"test/a.cl", {}, {}};
  source.generated["test/a.cl"] = "int a;\n#include \"test/nowhere.clh\"\n";
  const std::string message = messageOf([&] { joinSource(source); });
  EXPECT_TRUE(contains(message, "kernels/test/a.cl:2")) << message;
  EXPECT_TRUE(contains(message, "test/nowhere.clh")) << message;
  source.generated["test/a.cl"] = "#include CDSM_UNKNOWN\n";
  EXPECT_TRUE(contains(messageOf([&] { joinSource(source); }), "kernels/test/a.cl:1"));
  EXPECT_THROW(joinSource({"test/nowhere.cl", {}, {}}), Error);
}

TEST(JoinSource, readsFromTheFolderInTheEnvironment) {
  TemporaryFolder folder;
  ScopedEnvironment environment("CDSM_KERNELS", folder.path().string());
  overwrite(folder.path() / "a.cl", "int fromFolder;\n");
  EXPECT_TRUE(contains(joinSource({"a.cl", {}, {}}), "int fromFolder;"));
}

class ProgramCacheTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  ScopedEnvironment environment_{"CDSM_CACHE_DIR", (folder_.path() / "deep" / "cache").string()};
  std::unique_ptr<Device> device_ = Device::open();

  fs::path entry() { return filesIn(folder_.path() / "deep" / "cache").at(0); }
};

TEST_F(ProgramCacheTest, namesRealFileAndLineOfACompileError) {
  ProgramSource source{"test/a.cl", {}, {}};
  source.generated["test/a.cl"] = "#include \"test/bad.clh\"\nkernel void f(global int* p) { p[0] = bad(); }\n";
  source.generated["test/bad.clh"] = "int good(void) { return 1; }\n\nint bad(void) { return undeclaredName; }\n";
  const std::string message = messageOf([&] { device_->programs().get(source); });
  EXPECT_TRUE(contains(message, "test/a.cl does not build")) << message;
  EXPECT_TRUE(contains(message, "undeclaredName")) << message;
  const bool keepsLineMarks = !contains(device_->description().platform, "Oclgrind");
  if (keepsLineMarks) {
    EXPECT_TRUE(contains(message, "kernels/test/bad.clh:3")) << message;
  }
  EXPECT_FALSE(contains(message, "\n")) << message;
}

TEST_F(ProgramCacheTest, buildsOnceAndThenServesFromMemory) {
  const cl::Program& first = device_->programs().get(constantProgram(7));
  const cl::Program& second = device_->programs().get(constantProgram(7));
  EXPECT_EQ(&first, &second);
  EXPECT_EQ(runConstant(*device_, first), 7);
  EXPECT_EQ(runConstant(*device_, device_->programs().get(constantProgram(8))), 8);
  EXPECT_EQ(device_->programs().counts().builds, 2);
  EXPECT_EQ(device_->programs().counts().memoryHits, 1);
}

TEST_F(ProgramCacheTest, servesAnotherCacheFromDisk) {
  device_->programs().get(constantProgram(5));
  ProgramCache other(*device_);
  EXPECT_EQ(runConstant(*device_, other.get(constantProgram(5))), 5);
  EXPECT_EQ(other.counts().diskHits, 1);
  EXPECT_EQ(other.counts().builds, 0);
}

TEST_F(ProgramCacheTest, buildsFromSourceWhenAnEntryIsDamaged) {
  device_->programs().get(constantProgram(5));
  const std::string intact = contentOf(entry());
  std::string flipped = intact;
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
  for (const std::string& damaged : {flipped, intact.substr(0, intact.size() - 1), intact.substr(0, 10), std::string(),
                                     std::string("nonsense"), intact + "x"}) {
    overwrite(entry(), damaged);
    ProgramCache other(*device_);
    EXPECT_EQ(runConstant(*device_, other.get(constantProgram(5))), 5);
    EXPECT_EQ(other.counts().builds, 1);
    ProgramCache repaired(*device_);
    repaired.get(constantProgram(5));
    EXPECT_EQ(repaired.counts().diskHits, 1);
  }
}

TEST_F(ProgramCacheTest, doesWithoutAFolderThatCannotBeMade) {
  overwrite(folder_.path() / "file", "");
  ScopedEnvironment blocked("CDSM_CACHE_DIR", (folder_.path() / "file" / "below").string());
  EXPECT_EQ(runConstant(*device_, device_->programs().get(constantProgram(9))), 9);
  EXPECT_EQ(device_->programs().counts().builds, 1);
}

}  // namespace
}  // namespace cdsm::device
