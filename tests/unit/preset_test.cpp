// SPDX-License-Identifier: Apache-2.0
// ParaView's presets: points as they stand, colour spaces at values by hand, and what is refused.
#include <cmath>

#include "io/preset_file.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::expectError;

const char* const kJson = R"([{"ColorSpace": "RGB", "Name": "a", "NanColor": [1, 1, 0],
 "RGBPoints": [0, 0, 0, 0, 0.5, 1, 0, 0, 1, 1, 1, 1],
 "Points": [0, 0, 0.5, 0, 1, 0.8, 0.5, 0]}])";
const char* const kXml =
    "<ColorMaps>\n<ColorMap name=\"a\" space=\"RGB\">\n<Point x=\"-1\" o=\"0\" r=\"0\" g=\"0\" b=\"0\"/>\n"
    "<Point x=\"1\" o=\"0.5\" r=\"1\" g=\"0\" b=\"0\"/>\n<NaN r=\"1\" g=\"1\" b=\"0\"/>\n</ColorMap>\n</ColorMaps>\n";

double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

class Presets : public testing::Test {
 protected:
  TransferFunction read(const std::string& name, const std::string& text,
                        std::optional<std::pair<double, double>> range = std::nullopt) const {
    return io::readPreset(folder.write(name, text), range);
  }
  void expectRefused(const std::string& name, const std::string& text, const std::string& part, int line = 0) const {
    expectError([&] { read(name, text); }, part, line);
  }
  void expectSpoiled(const std::string& from, const std::string& to, const std::string& part) const {
    expectRefused("a.json", test::replaced(kJson, from, to), part);
  }
  /// Halfway between blue-ish (0, 0, 1) and red (1, 0, 0) in that space, as a display shows it.
  void expectMiddle(const std::string& space, const glm::dvec3& expected) const {
    const TransferFunction transfer =
        read("s.json", "{\"ColorSpace\": \"" + space + "\", \"RGBPoints\": [0, 0, 0, 1, 2, 1, 0, 0]}");
    for (const auto& point : transfer.color)
      if (point.value == 1.0f) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(srgb(point.color[i]), expected[i], 0.002) << space << " " << i;
        return;
      }
    ADD_FAILURE() << space << " has no point in the middle";
  }

  test::TemporaryFolder folder;
};

/// Between its points the function is linear.
double opacityAt(const TransferFunction& transfer, float value) {
  for (std::size_t i = 1; i < transfer.opacity.size(); ++i) {
    const auto& a = transfer.opacity[i - 1];
    const auto& b = transfer.opacity[i];
    if (value > b.value) continue;
    return a.opacity + (b.opacity - a.opacity) * (value - a.value) / (b.value - a.value);
  }
  return -1.0;
}

TEST_F(Presets, JsonGivesColoursAndOpacitiesAsTheyAre) {
  const TransferFunction transfer = read("a.json", kJson);
  ASSERT_EQ(transfer.opacity.size(), 2u);
  EXPECT_EQ(transfer.opacity[1].value, 1.0f);
  EXPECT_EQ(transfer.opacity[1].opacity, 0.8f);
  EXPECT_EQ(transfer.color.front().value, 0.0f);
  EXPECT_EQ(transfer.color.back().value, 1.0f);
  for (const auto& point : transfer.color) {  // halfway on a display is not halfway in light
    const double red = std::min(2.0 * point.value, 1.0), blue = std::max(2.0 * point.value - 1.0, 0.0);
    EXPECT_NEAR(srgb(point.color.r), red, 1e-5);
    EXPECT_NEAR(srgb(point.color.b), blue, 1e-5);
  }
}

TEST_F(Presets, XmlGivesOpacitiesUnlessAllAreOne) {
  const TransferFunction transfer = read("a.xml", kXml);
  ASSERT_EQ(transfer.opacity.size(), 2u);
  EXPECT_EQ(transfer.opacity[0].value, -1.0f);
  EXPECT_EQ(transfer.opacity[1].opacity, 0.5f);
  EXPECT_EQ(transfer.color.back().color, glm::vec3(1.0f, 0.0f, 0.0f));
  const std::string solid = test::replaced(test::replaced(kXml, "o=\"0\"", "o=\"1\""), "o=\"0.5\"", "o=\"1\"");
  EXPECT_TRUE(read("b.xml", solid).opacity.empty());
}

TEST_F(Presets, RangeStretchesFirstToLastColour) {
  const TransferFunction transfer = read("a.xml", kXml, std::pair<double, double>(100.0, 300.0));
  EXPECT_EQ(transfer.color.front().value, 100.0f);
  EXPECT_EQ(transfer.color.back().value, 300.0f);
  EXPECT_EQ(transfer.opacity.back().value, 300.0f);
}

TEST_F(Presets, ColourSpacesBendTheWay) {
  expectMiddle("RGB", {0.5, 0.0, 0.5});
  expectMiddle("HSV", {0.0, 1.0, 0.0});        // hue 2/3 to 0, by 1/3
  expectMiddle("Lab", {0.7920, 0.0, 0.5356});  // L 42.8, a 79.65, b -20.3
  expectMiddle("Diverging", {1.0, 1.0, 1.0});  // no saturation, the magnitude of blue, 137, which no display shows
  EXPECT_EQ(read("s.json", R"({"ColorSpace": "Step", "RGBPoints": [0, 0, 0, 1, 2, 1, 0, 0]})").color[1].color,
            glm::vec3(1.0f, 0.0f, 0.0f));
  const TransferFunction wrapped =
      read("w.json", R"({"ColorSpace": "HSV", "HSVWrap": 1, "RGBPoints": [0, 0, 0, 1, 2, 1, 0, 0]})");
  for (const auto& point : wrapped.color) EXPECT_EQ(point.color.g, 0.0f);  // over magenta
}

TEST_F(Presets, MidpointsAndSharpnessBendOpacity) {
  const auto at = [&](const std::string& points, float value) {
    return opacityAt(read("a.json", R"({"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "Points": [)" + points + "]}"), value);
  };
  EXPECT_NEAR(at("0, 0, 0.25, 0, 1, 1, 0.5, 0", 0.25f), 0.5, 1e-6);
  EXPECT_NEAR(at("0, 0, 0.25, 0, 1, 1, 0.5, 0", 0.625f), 0.75, 1e-6);
  EXPECT_NEAR(at("0, 0, 0.5, 1, 1, 1, 0.5, 0", 0.4f), 0.0055, 0.001);  // h(0.5 * 0.8^11), h(s) = 3 s^2 - 2 s^3
  EXPECT_NEAR(at("0, 0, 0.5, 1, 1, 1, 0.5, 0", 0.6f), 0.9945, 0.001);
  EXPECT_NEAR(at("0, 0, 0.5, 0.5, 1, 1, 0.5, 0", 0.5f), 0.5, 1e-6);
}

TEST_F(Presets, OthersAreRefused) {
  expectError([&] { io::readPreset(folder.path("none.json"), {}); }, "no such file");
  expectRefused("a.txt", kJson, "not known as a preset by its ending");
  expectRefused("a.json", "[{\n\"RGBPoints\": [0,", "is not JSON", 2);
  expectRefused("a.json", "[" + std::string(100000, '['), "is not JSON");
  expectRefused("a.json", "[1]", "must be an object");
  expectRefused("a.json", "{}", "no RGBPoints");
  expectRefused("a.json", "[{}, {}]", "holds 2 presets");
  expectRefused("a.json", "{\"IndexedColors\": [1, 1, 1]}", "categories");
  expectRefused("a.json", "{\"RGBPoints\": []}", "no points of colour");
  expectSpoiled("0.5, 1, 0, 0", "0.5, 1, 0", "4 to a point");
  expectSpoiled("0.5, 1, 0, 0", "0.5, 1, 0, \"0\"", "4 to a point");
  expectSpoiled("0.5, 1, 0, 0", "0.5, 1, 0, 2", "colour is 2, must be in [0, 1]");
  expectSpoiled("0.5, 1, 0, 0", "1.5, 1, 0, 0", "1 follows 1.5, must be ascending");
  expectSpoiled("0.5, 1, 0, 0", "1e999, 1, 0, 0", "");
  expectSpoiled("1, 0.8, 0.5, 0", "1, 1.8, 0.5, 0", "opacity is 1.8");
  expectSpoiled("0, 0, 0.5, 0", "0, 0, 1, 0", "midpoint is 1");
  expectSpoiled("\"RGB\"", "\"Lab/CIEDE2000\"", "colour space \"Lab/CIEDE2000\"");
  expectSpoiled("\"Name\"", "\"UseLogScale\": 1, \"Name\"", "logarithmic");
  expectRefused("a.xml", test::replaced(kXml, "r=\"1\"", "r=\"much\""), "r is \"much\"", 4);
  expectRefused("a.xml", test::replaced(kXml, "b=\"0\"/>\n<NaN", "/>\n<NaN"), "b is \"\"", 4);
  expectRefused("a.xml", test::replaced(kXml, "</ColorMap>", "</ColorMap><ColorMap/>"), "second ColorMap", 6);
  expectRefused("a.xml", "<html/>", "no ColorMap", 1);
  expectRefused("a.xml", "", "empty");
}

}  // namespace
