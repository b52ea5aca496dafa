// SPDX-License-Identifier: Apache-2.0
// compare.json by its schema, and the page: self-contained, escaped, with every technique.
#include "comparison.hpp"

#include <memory>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cdsm/error.hpp>

#include "device/device.hpp"
#include "technique/registry.hpp"

namespace cdsm::cli {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The last technique cannot be used.
Comparison example() {
  Comparison comparison;
  comparison.scene = "a<b>&\"c\".toml";
  comparison.settings = {"image.width=64"};
  for (const ShadowVariant& variant : shadowVariants()) {
    VariantResult result;
    result.variant = variant;
    result.difference = {0.1, -0.02, 0.9, 12.0};
    result.buildMs = 12.5;
    result.frameMs = 2.0 * double(comparison.results.size() + 1);
    result.frames = 3;
    result.bytes = 3u << 20;
    comparison.results.push_back(result);
  }
  comparison.results.back().reason = "no <spheres> here";
  return comparison;
}

std::map<std::string, std::string> pictures() {
  std::map<std::string, std::string> uris;
  for (const ShadowVariant& variant : shadowVariants())
    for (const std::string& name : {pictureName(variant), differenceName(variant)})
      uris[name] = "data:image/png;base64," + name;
  return uris;
}

TEST(ShadowVariants, AreTheirSettings) {
  std::set<std::string> names;
  for (const ShadowVariant& variant : shadowVariants()) {
    EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
    EXPECT_EQ(variant.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos);
    const ShadowSettings settings = variant.applied({});
    EXPECT_NE(variant.options().find("--set shadows.technique=" + settings.technique), std::string::npos);
  }
  EXPECT_EQ(referenceVariant().applied({}).technique, "shadow-rays");
  EXPECT_EQ(referenceVariant().applied({}).rays, "exact");
}

/// The registry tells its techniques when asked for one that there is not.
std::string knownTechniques() {
  const std::unique_ptr<device::Device> device = device::Device::open();
  ShadowSettings shadows;
  shadows.technique = "?";
  try {
    technique::makeTechnique(shadows, *device);
  } catch (const Error& error) {
    const std::string message = error.what();
    return message.substr(message.find("known: ") + 7) + ",";
  }
  return "";
}

TEST(ShadowVariants, LeaveNoTechniqueOut) {
  std::set<std::string> compared;
  for (const ShadowVariant& variant : shadowVariants()) compared.insert(variant.applied({}).technique);
  std::istringstream known(knownTechniques());
  std::size_t count = 0;
  for (std::string name; known >> name; ++count) {
    name.pop_back();  // its comma
    EXPECT_EQ(compared.count(name), 1u) << name << " is missing in compare_variants.cpp";
  }
  EXPECT_GE(count, 4u);
}

TEST(ComparisonJson, HasItsKeys) {
  const auto json = nlohmann::json::parse(comparisonJson(example()));
  EXPECT_EQ(json.at("scene"), "a<b>&\"c\".toml");
  EXPECT_EQ(json.at("settings"), nlohmann::json({"image.width=64"}));
  EXPECT_EQ(json.at("reference"), "shadow-rays");
  EXPECT_EQ(json.at("difference_factor"), 10.0);
  for (const char* key : {"platform", "name", "version"}) EXPECT_TRUE(json.at("device").at(key).is_string());
  for (const char* key : {"width", "height", "supersampling"}) EXPECT_TRUE(json.at("image").at(key).is_number());
  ASSERT_EQ(json.at("techniques").size(), shadowVariants().size());
  for (const auto& technique : json.at("techniques")) {
    EXPECT_TRUE(technique.at("settings").at("shadows.technique").is_string());
    if (technique.contains("reason")) continue;
    EXPECT_EQ(technique.at("image"), technique.at("name").get<std::string>() + ".png");
    EXPECT_EQ(technique.contains("difference"), technique.at("name") != json.at("reference"));
    const std::map<std::string, double> error = technique.at("error");
    EXPECT_EQ(error, (std::map<std::string, double>{
                         {"rms", 0.1}, {"mean_luminance", -0.02}, {"largest", 0.9}, {"perceived", 12.0}}));
    EXPECT_EQ(technique.at("time_ms").at("build"), 12.5);
    EXPECT_EQ(technique.at("frames_timed"), 3);
    EXPECT_EQ(technique.at("bytes"), 3 << 20);
  }
  EXPECT_EQ(json.at("techniques").back().at("reason"), "no <spheres> here");
  EXPECT_FALSE(json.at("techniques").back().contains("image"));
}

TEST(ComparisonPage, NeedsNothingFromElsewhere) {
  const std::string page = comparisonPage(example(), pictures());
  for (const char* marker : {"http:", "https:", "//", "<script", "<link", "@import", "file:"})
    EXPECT_EQ(page.find(marker), std::string::npos) << marker;
  EXPECT_EQ(countOf(page, "src="), countOf(page, "src=\"data:image/png;base64,"));
  EXPECT_EQ(countOf(page, "url("), countOf(page, "url(\"data:image/png;base64,"));
}

TEST(ComparisonPage, ShowsEveryTechniqueAndEscapesTexts) {
  const Comparison comparison = example();
  const std::string page = comparisonPage(comparison, pictures());
  for (const VariantResult& result : comparison.results) {
    const std::size_t shown = result.reason.empty() ? 1 : 0;
    const std::size_t asReference = result.variant.name == referenceVariant().name ? 1 : 0;  // to flip to
    EXPECT_EQ(countOf(page, "base64," + pictureName(result.variant)), shown + asReference) << result.variant.name;
    EXPECT_EQ(countOf(page, "base64," + differenceName(result.variant)), asReference ? 0 : shown);
    EXPECT_EQ(countOf(page, "<h2>" + result.variant.name + "<"), 1u);
  }
  EXPECT_EQ(countOf(page, "no &lt;spheres&gt; here"), 2u) << "in the table and in its place";
  EXPECT_EQ(page.find("a<b>"), std::string::npos);
  EXPECT_NE(page.find("a&lt;b&gt;&amp;&quot;c&quot;.toml"), std::string::npos);
  for (const char* tag : {"section", "figure", "table", "tr", "td", "th", "span", "div", "p"})
    EXPECT_EQ(countOf(page, std::string("<") + tag + " ") + countOf(page, std::string("<") + tag + ">"),
              countOf(page, std::string("</") + tag + ">"))
        << tag;
}

}  // namespace
}  // namespace cdsm::cli
