// SPDX-License-Identifier: Apache-2.0
// Points in, transmittances out: forms that are allowed, errors with line and column, and digits that read back.
#include "io/points_file.hpp"

#include <limits>
#include <sstream>

#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::dataFile;
using cdsm::test::expectError;
using cdsm::test::readBytes;

TEST(PointsFile, AllowsMarksSpacesLineEndsAndBlankLinesAtTheEnd) {
  const std::vector<glm::vec3> points = io::readPoints(dataFile("points.csv"));
  EXPECT_EQ(points, (std::vector<glm::vec3>{{0, 0.5f, -1e-3f}, {1.25f, 2, 3}}));
}

TEST(PointsFile, AllowsNoPointsAndNoLastLineEnd) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(io::readPoints(folder.write("a.csv", "x,y,z")).empty());
  EXPECT_TRUE(io::readPoints(folder.write("a.csv", "x,y,z\n")).empty());
  EXPECT_EQ(io::readPoints(folder.write("a.csv", "x,y,z\n1,2,3")), (std::vector<glm::vec3>{{1, 2, 3}}));
  EXPECT_EQ(io::readPoints(folder.write("a.csv", "x,y,z\n1e-60,-0,3"))[0].x, 0.0f);
}

TEST(PointsFile, ErrorsNameLineAndColumn) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& part, int line, int column) {
    const std::string path = folder.write("a.csv", text);
    expectError([&] { io::readPoints(path); }, part, line, column);
  };
  refused("1,2,3\n", "header x,y,z", 1, 1);
  refused("x,y\n1,2\n", "header x,y,z", 1, 1);
  refused("x,y,z,w\n", "header x,y,z", 1, 1);
  refused("\n", "header x,y,z", 1, 1);
  refused("x,y,z\n1,2,3\n1,  two,3\n", "\"two\" is not a finite number", 3, 5);
  refused("x,y,z\n1,2,nan\n", "\"nan\" is not a finite number", 2, 5);
  refused("x,y,z\n1e39,2,3\n", "\"1e39\"", 2, 1);
  refused("x,y,z\n1,,3\n", "\"\" is not", 2, 3);
  refused("x,y,z\n1,2\n", "three values", 2, 4);
  refused("x,y,z\n1,2,3,4\n", "fourth", 2, 7);
  refused("x,y,z\n1,2,3\n\n4,5,6\n", "blank line", 3, 1);
  refused("x,y,z\n1;2;3\n", "three values", 2, 6);
  refused("x,y,z\n1,2,0x10\n", "\"0x10\"", 2, 5);
  expectError([&] { io::readPoints(folder.path("none.csv")); }, "no such file");
  refused("", "empty", 0, 0);
}

TEST(PointsFile, WritesRowsInOrderWithTheShortestDigits) {
  std::ostringstream out;
  io::writeTransmittances(out, {{0.1f, -2, 1e20f}, {1.0f / 3.0f, 0, 5}}, {{1, 0.5f, {}}, {0, 0.0f, {}}});
  EXPECT_EQ(out.str(), "x,y,z,lit,transmittance\n0.1,-2,1e+20,1,0.5\n0.33333334,0,5,0,0\n");
}

TEST(PointsFile, WrittenNumbersReadBackAsTheSameFloats) {
  const test::TemporaryFolder folder;
  std::vector<glm::vec3> points;
  for (int i = 1; i < 200; ++i)
    points.emplace_back(1.0f / static_cast<float>(i), -std::numeric_limits<float>::max() / static_cast<float>(i),
                        std::numeric_limits<float>::denorm_min() * static_cast<float>(i));
  io::writeTransmittances(folder.path("a.csv"), points, std::vector<Transmittance>(points.size(), {1, 0.25f, {}}));
  EXPECT_EQ(folder.files(), 1u);
  std::string text = readBytes(folder.path("a.csv"));
  for (std::size_t at = 0; (at = text.find(",1,0.25\n")) != std::string::npos;) text.erase(at, 7);
  text = test::replaced(text, "x,y,z,lit,transmittance", "x,y,z");
  EXPECT_EQ(io::readPoints(folder.write("b.csv", text)), points);
}

TEST(PointsFile, AFailingWriteLeavesTheEarlierFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old");
  EXPECT_THROW(io::writeTransmittances(path, {{0, 0, 0}}, {}), Error);
  EXPECT_EQ(readBytes(path), "old");
  EXPECT_EQ(folder.files(), 1u);
  expectError([&] { io::writeTransmittances(folder.path("none/a.csv"), {}, {}); }, "does not exist");
  std::ostringstream broken;
  broken.setstate(std::ios::badbit);
  EXPECT_THROW(io::writeTransmittances(broken, {}, {}), Error);
}

}  // namespace
