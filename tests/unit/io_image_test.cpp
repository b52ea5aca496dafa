// SPDX-License-Identifier: Apache-2.0
// Images there and back, the sRGB curve, and that a failing write leaves what was there.
#include "io/image_file.hpp"

#include <cmath>
#include <limits>

#include "io/atomic_file.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::expectError;
using cdsm::test::readBytes;

Image row(const std::vector<glm::vec4>& pixels) { return Image{static_cast<int>(pixels.size()), 1, pixels}; }

TEST(ImageFile, ExrKeepsEveryBitAndAlpha) {
  const test::TemporaryFolder folder;
  const Image image{2,
                    3,
                    {{0.1f, 2.5f, -1.0f, 0.0f},
                     {1e-8f, 1e8f, 0.3f, 0.25f},
                     {1, 2, 3, 1},
                     {4, 5, 6, 0.5f},
                     {7, 8, 9, 1},
                     {0, 0, 0, 0}}};
  writeImage(folder.path("a.exr"), image);
  const Image read = io::readImage(folder.path("a.exr"));
  EXPECT_EQ(read.width, 2);
  EXPECT_EQ(read.height, 3);
  EXPECT_EQ(read.pixels, image.pixels);
}

TEST(ImageFile, PngFollowsTheSrgbCurve) {
  const test::TemporaryFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  // 0.5 -> 188, 0.0031308 -> 10, 0.001 -> 3 (linear part), 0.21586 -> 128; clamped outside, NaN is black.
  writeImage(folder.path("a.png"),
             row({{0.5f, 0.0031308f, 0.001f, 0.3f}, {0.21586f, -1.0f, 7.0f, 0.0f}, {1.0f, 0.0f, nan, 1.0f}}));
  const Image read = io::readImage(folder.path("a.png"));
  const int expected[3][3] = {{188, 10, 3}, {128, 0, 255}, {255, 0, 0}};
  for (int pixel = 0; pixel < 3; ++pixel)
    for (int channel = 0; channel < 3; ++channel) {
      const double encoded = expected[pixel][channel] / 255.0;
      const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
      EXPECT_NEAR(read.pixels[pixel][channel], linear, 1e-6) << pixel << " " << channel;
    }
  EXPECT_EQ(read.pixels[0].a, 1.0f);
}

TEST(ImageFile, SameImageSameBytes) {
  const test::TemporaryFolder folder;
  for (const char* ending : {".png", ".exr"}) {
    const Image image = row({{0.5f, 0.2f, 0.1f, 0.3f}, {0, 1, 2, 1}});
    writeImage(folder.path(std::string("a") + ending), image);
    writeImage(folder.path(std::string("b") + ending), image);
    EXPECT_EQ(readBytes(folder.path(std::string("a") + ending)), readBytes(folder.path(std::string("b") + ending)));
  }
}

TEST(ImageFile, ReplacesAnEarlierFileAndLeavesNothingElse) {
  const test::TemporaryFolder folder;
  writeImage(folder.write("a.png", "old"), row({glm::vec4(1.0f)}));
  EXPECT_EQ(io::readImage(folder.path("a.png")).pixels[0], glm::vec4(1.0f));
  EXPECT_EQ(folder.files(), 1u);
}

TEST(ImageFile, AFailingWriteLeavesTheEarlierFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.exr", "old");
  expectError([&] { writeImage(path, Image{2, 2, {glm::vec4(0.0f)}}); }, "2 x 2 with 1 pixels");
  expectError([&] { writeImage(path, Image{}); }, "cannot be written");
  EXPECT_EQ(readBytes(path), "old");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(ImageFile, AWriterThatFailsHalfwayLeavesTheEarlierFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.png", "old");
  // libpng refuses more than a million columns, when the temporary file is there already.
  expectError([&] { writeImage(path, row(std::vector<glm::vec4>(1000001))); }, "cannot be written");
  EXPECT_EQ(readBytes(path), "old");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(ImageFile, PathsThatCannotBeWritten) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("folder.png"));
  const auto refused = [](const std::string& path, const std::string& part) {
    expectError([&] { io::checkImagePath(path); }, part);
    expectError([&] { writeImage(path, row({glm::vec4(0.0f)})); }, part);
  };
  refused(folder.path("a.jpg"), ".png or .exr");
  refused(folder.path("a"), ".png or .exr");
  refused(folder.path("none/a.png"), "does not exist");
  refused(folder.path("folder.png"), "is a folder");
  refused(folder.write("file", "") + "/a.png", "does not exist");
  EXPECT_EQ(folder.files(), 2u);
}

TEST(ImageFile, CheckingAPathLeavesNothing) {
  const test::TemporaryFolder folder;
  io::checkImagePath(folder.path("a.png"));
  io::checkImagePath(folder.path("A.EXR"));
  EXPECT_EQ(folder.files(), 0u);
}

TEST(ImageFile, ReadingRefusesWhatIsNoImage) {
  const test::TemporaryFolder folder;
  expectError([&] { io::readImage(folder.path("a.png")); }, "no such file");
  expectError([&] { io::readImage(folder.write("a.png", "hello")); }, "cannot be read as an image");
  expectError([&] { io::readImage(folder.write("a.exr", "hello")); }, "cannot be read as an image");
}

TEST(AtomicFile, OnlyCommitReplaces) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "old");
  {
    io::AtomicFile file(path);
    std::ofstream(file.temporaryPath()) << "new";
  }
  EXPECT_EQ(readBytes(path), "old");
  EXPECT_EQ(folder.files(), 1u);
  io::AtomicFile file(path);
  std::ofstream(file.temporaryPath()) << "new";
  file.commit();
  EXPECT_EQ(readBytes(path), "new");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, FollowsLinksAndSparesDevices) {
  const test::TemporaryFolder folder;
  std::filesystem::create_symlink(folder.write("real.txt", "old"), folder.path("link.txt"));
  io::AtomicFile file(folder.path("link.txt"));
  std::ofstream(file.temporaryPath()) << "new";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.txt")));
  EXPECT_EQ(readBytes(folder.path("real.txt")), "new");
  expectError([] { io::checkOutputPath("/dev/null"); }, "not a regular file");
}

}  // namespace
