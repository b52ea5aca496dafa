// SPDX-License-Identifier: Apache-2.0
// Files for the io tests: the small inputs of tests/data, a folder that vanishes, and the check that a call throws.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include <cdsm/error.hpp>

namespace cdsm::test {

/// A file of tests/data, which make_data.py writes. The build says where that is.
inline std::string dataFile(const std::string& name) { return (std::filesystem::path(CDSM_TEST_DATA) / name).string(); }

inline std::string readBytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// A new folder for one test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cdsm_io_XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error("no temporary folder can be made");
    folder_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

 private:
  std::filesystem::path folder_;
};

/// `text` with the first `from` replaced; a test that replaces nothing is wrong.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw Error("\"" + from + "\" is not in the file to spoil");
  return text.replace(at, from.size(), to);
}

/// The call throws an Error of one line that says `part` and stands at `line` and `column` of a file (0: anywhere).
template <typename Call>
void expectError(Call call, const std::string& part, int line = 0, int column = 0) {
  try {
    call();
    ADD_FAILURE() << "no Error; expected: " << part;
  } catch (const Error& error) {
    EXPECT_NE(error.message().find(part), std::string::npos) << "message: " << error.what() << "\nexpected: " << part;
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    ASSERT_TRUE(error.where().has_value()) << error.what();
    EXPECT_FALSE(error.where()->file.empty());
    EXPECT_TRUE(line == 0 || error.where()->line == line) << "at line " << line << ", not " << error.what();
    EXPECT_TRUE(column == 0 || error.where()->column == column) << "at column " << column << ", not " << error.what();
  }
}

}  // namespace cdsm::test
