// SPDX-License-Identifier: Apache-2.0
// Folders as results: whole or not at all, and never in the place of other people's files.
#include "io/atomic_folder.hpp"

#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::expectError;
using cdsm::test::readBytes;

const std::set<std::string> kOwn{"a.txt", "b.txt"};

class AtomicFolder : public testing::Test {
 protected:
  void put(io::AtomicFolder& folder, const std::string& text) { std::ofstream(folder.file("a.txt")) << text; }
  void writeResult(const std::string& text) {
    io::AtomicFolder folder(path_, kOwn);
    put(folder, text);
    folder.commit();
  }
  std::string content() { return readBytes(path_ + "/a.txt"); }

  test::TemporaryFolder around_;
  const std::string path_ = around_.path("result");
};

TEST_F(AtomicFolder, IsThereOnceItIsDone) {
  {
    io::AtomicFolder folder(path_ + "/", kOwn);
    put(folder, "new");
    EXPECT_FALSE(std::filesystem::exists(path_));
    folder.commit();
    EXPECT_EQ(content(), "new");
  }
  EXPECT_EQ(content(), "new");
  EXPECT_EQ(around_.files(), 1u);
}

TEST_F(AtomicFolder, ReplacesAnEarlierResultAsAWhole) {
  writeResult("old");
  std::ofstream(path_ + "/b.txt") << "not in the new one";
  writeResult("new");
  EXPECT_EQ(content(), "new");
  EXPECT_FALSE(std::filesystem::exists(path_ + "/b.txt"));
  EXPECT_EQ(around_.files(), 1u);
}

TEST_F(AtomicFolder, LeavesAnEarlierResultIfItIsNotDone) {
  writeResult("old");
  {
    io::AtomicFolder folder(path_, kOwn);
    put(folder, "half");
  }
  EXPECT_EQ(content(), "old");
  EXPECT_EQ(around_.files(), 1u);
}

TEST_F(AtomicFolder, FollowsALink) {
  std::filesystem::create_directory(around_.path("real"));
  std::filesystem::create_directory_symlink("real", path_);
  writeResult("new");
  EXPECT_TRUE(std::filesystem::is_symlink(path_));
  EXPECT_EQ(readBytes(around_.path("real/a.txt")), "new");
}

TEST_F(AtomicFolder, RefusesWhatIsNotItsOwn) {
  around_.write("result", "a file");
  expectError([&] { io::AtomicFolder(path_, kOwn); }, "is a file; name a folder");
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  std::ofstream(path_ + "/thesis.tex") << "work of years";
  expectError([&] { io::AtomicFolder(path_, kOwn); }, "holds thesis.tex, which is no part of a result");
  std::filesystem::remove(path_ + "/thesis.tex");
  std::filesystem::create_directory(path_ + "/a.txt");
  expectError([&] { io::AtomicFolder(path_, kOwn); }, "holds a.txt");
  expectError([&] { io::AtomicFolder(around_.path("none/result"), kOwn); }, "does not exist; make it first");
  EXPECT_EQ(around_.files(), 1u);
}

}  // namespace
