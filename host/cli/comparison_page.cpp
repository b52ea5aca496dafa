// SPDX-License-Identifier: Apache-2.0
// index.html: a table of all figures, then each technique with its picture and its difference to the reference.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "bench_tables.hpp"
#include "comparison.hpp"
#include "comparison_style.hpp"
#include "io/srgb.hpp"

namespace cdsm::cli {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string element(const std::string& tag, const std::string& content, const std::string& attributes = "") {
  const std::string name = tag.substr(0, tag.find(' '));
  return "<" + tag + attributes + ">" + content + "</" + name + ">";
}

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string milliseconds(double ms) { return ms >= 10000.0 ? fixed(ms / 1000.0, 1) + " s" : numberText(ms) + " ms"; }

std::string memoryText(std::uint64_t bytes) {
  constexpr double kKibi = 1024.0;
  if (bytes == 0) return "–";
  const double kib = double(bytes) / kKibi;
  return kib < kKibi ? fixed(kib, 0) + " KiB" : fixed(kib / kKibi, kib < 10.0 * kKibi ? 1 : 0) + " MiB";
}

bool isReference(const VariantResult& result) { return result.variant.name == referenceVariant().name; }

/// Frame time without shadows; 0 if there is none.
double plainFrameMs(const Comparison& comparison) {
  for (const VariantResult& result : comparison.results)
    if (result.variant.name == "none") return result.frameMs;
  return 0.0;
}

/// A cell with a bar behind it, as long as the value's part of the greatest in its column.
std::string barCell(const std::string& text, double value, double greatest) {
  if (!(greatest > 0.0)) return element("td", text);
  return element("td class=\"bar\"", text, " style=\"--part: " + fixed(0.9 * value / greatest, 3) + "\"");
}

std::string row(const VariantResult& result, const Comparison& comparison, const io::ImageDifference& worst) {
  const std::string tag = isReference(result) ? element("span class=\"tag\"", "reference") : "";
  const std::string head = element("th scope=\"row\"", escaped(result.variant.name) + tag);
  if (!result.reason.empty())
    return element("tr", head + element("td class=\"reason\" colspan=\"7\"", escaped(result.reason)));
  const io::ImageDifference& difference = result.difference;
  const double plain = plainFrameMs(comparison);
  const std::string dash = element("td class=\"soft\"", "–");
  std::string cells = head;
  if (isReference(result)) {
    cells += dash + dash + dash;
  } else {
    cells += barCell(fixed(difference.rms, 4), difference.rms, worst.rms);
    cells += barCell(fixed(difference.perceived, 1), difference.perceived, worst.perceived);
    cells += element("td", (difference.mean > 0.0 ? "+" : "") + fixed(difference.mean, 4));
  }
  cells += result.buildMs > 0.0 ? element("td", milliseconds(result.buildMs)) : dash;
  cells += element("td", milliseconds(result.frameMs));
  cells += plain > 0.0 ? element("td", "× " + fixed(result.frameMs / plain, 2)) : dash;
  return element("tr", cells + element("td", memoryText(result.bytes))) + "\n";
}

std::string table(const Comparison& comparison) {
  io::ImageDifference worst;
  for (const VariantResult& result : comparison.results) {
    worst.rms = std::max(worst.rms, result.difference.rms);
    worst.perceived = std::max(worst.perceived, result.difference.perceived);
  }
  std::string head, rows;
  for (const char* title : {"technique", "RMS error", "perceived", "bias", "build", "frame", "frame / none", "maps"})
    head += element("th scope=\"col\"", title);
  for (const VariantResult& result : comparison.results) rows += row(result, comparison, worst);
  return element("div class=\"table\"",
                 element("table", element("thead", element("tr", head)) + "\n" + element("tbody", "\n" + rows))) +
         "\n";
}

std::string cssColor(double part) {
  const glm::vec3 linear = io::differenceColor(part);
  std::string text = "rgb(";
  for (int c = 0; c < 3; ++c) text += (c ? " " : "") + std::to_string(std::lround(255.0 * io::srgbOfLinear(linear[c])));
  return text + ")";
}

/// The colours of differences with the values at both ends.
std::string scale() {
  constexpr int kStops = 17;
  std::string stops;
  for (int i = 0; i < kStops; ++i) stops += ", " + cssColor(2.0 * i / (kStops - 1) - 1.0);
  const std::string end = numberText(1.0 / kDifferenceFactor);
  return element("span class=\"scale\"", "too dark −" + end + " <i style=\"background: linear-gradient(90deg" + stops +
                                             ")\"></i> +" + end + " too bright");
}

std::string picture(const std::string& uri, const std::string& alt) {
  return "<img src=\"" + uri + "\" alt=\"" + escaped(alt) + "\">";
}

std::string figures(const VariantResult& result, const std::map<std::string, std::string>& pictures) {
  const std::string& name = result.variant.name;
  const std::string image = picture(pictures.at(pictureName(result.variant)), "rendered with " + name);
  if (isReference(result)) return element("figure", element("div class=\"frame\"", image));
  const std::string flip = element("div class=\"frame flip\" tabindex=\"0\"", image) +
                           element("figcaption", "point at the picture to see the reference in its place");
  const std::string difference =
      element("div class=\"frame\"",
              picture(pictures.at(differenceName(result.variant)), "difference of " + name + " to the reference")) +
      element("figcaption",
              element("span", "luminance less that of the reference, × " + numberText(kDifferenceFactor)) + scale());
  return element("div class=\"pair\"", element("figure", flip) + "\n" + element("figure", difference));
}

std::string card(const VariantResult& result, const std::map<std::string, std::string>& pictures) {
  const std::string tag = isReference(result) ? element("span class=\"tag\"", "reference") : "";
  std::string html = element("header", element("h2", escaped(result.variant.name) + tag) +
                                           element("span class=\"soft\"", escaped(result.variant.what)));
  html += element("p", element("code class=\"soft\"", escaped(result.variant.options())));
  for (const std::string& warning : result.warnings) html += element("p", "Warning: " + escaped(warning));
  html += result.reason.empty() ? figures(result, pictures)
                                : element("p class=\"soft\"", "Not on this scene: " + escaped(result.reason));
  return element("section", "\n" + html + "\n") + "\n";
}

std::string howToRead() {
  const std::pair<const char*, const char*> terms[] = {
      {"RMS error", "root mean square of the difference to the reference, over pixels and channels of linear RGB"},
      {"perceived",
       "the difference as the eye takes it, by Butteraugli’s model, 3-norm over the pixels; 1: just noticeable"},
      {"bias", "mean difference of luminances: below 0 the picture is too dark"},
      {"build", "all maps of all lights and the cache, after the lights have changed; – where nothing is built"},
      {"frame", "a frame whose maps are there already, median, by the clock on the wall"},
      {"maps", "memory of the finished maps and of the cache on the device"}};
  std::string list;
  for (const auto& [term, meaning] : terms) list += element("dt", term) + element("dd", meaning) + "\n";
  return element("section", element("h2", "How to read this") + element("dl", "\n" + list)) + "\n";
}

std::string intro(const Comparison& comparison) {
  const ImageSettings& image = comparison.image;
  const ShadowSettings& shadows = comparison.shadows;
  std::string html = element("h1", "Shadow techniques compared");
  std::string command = "cdsm compare " + comparison.scene;
  for (const std::string& setting : comparison.settings) command += " --set " + setting;
  html += element("p", element("code", escaped(command)));
  std::ostringstream text;
  text << image.width << " × " << image.height << " pixels, " << image.supersampling * image.supersampling
       << (image.supersampling > 1 ? " rays" : " ray") << " each · maps of " << shadows.mapSize << "², tolerance "
       << shadows.tolerance << ", memory " << shadows.memory << ", threshold " << shadows.threshold << " · "
       << comparison.device.name;
  return html + element("p class=\"soft\"", escaped(text.str())) + "\n";
}

}  // namespace

std::string comparisonPage(const Comparison& comparison, const std::map<std::string, std::string>& pictures) {
  std::string body = intro(comparison) + table(comparison);
  for (const VariantResult& result : comparison.results) body += card(result, pictures);
  const std::string flip =
      ".flip::after { background-image: url(\"" + pictures.at(pictureName(referenceVariant())) + "\"); }\n";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         element("title", "Shadow techniques: " + escaped(comparison.scene)) + "\n" +
         element("style", kComparisonStyle + flip) + "\n</head>\n<body>\n<main>\n" + body + howToRead() +
         "</main>\n</body>\n</html>\n";
}

}  // namespace cdsm::cli
