// SPDX-License-Identifier: Apache-2.0
// Differences of images against a plain computation, and their colours.
#include "io/image_difference.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <cdsm/error.hpp>

namespace {

using namespace cdsm;

Image plain(int width, int height, glm::vec3 color) {
  return {width, height, std::vector<glm::vec4>(std::size_t(width * height), glm::vec4(color, 1.0f))};
}

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0.0f, 2.0f);
  Image image = plain(width, height, glm::vec3(0.0f));
  for (glm::vec4& pixel : image.pixels) pixel = {value(random), value(random), value(random), value(random)};
  return image;
}

TEST(ImageDifference, IsThatOfAPlainComputation) {
  const Image a = noise(13, 9, 1), b = noise(13, 9, 2);
  long double squares = 0.0L, mean = 0.0L, largest = 0.0L;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const long double weights[] = {0.2126L, 0.7152L, 0.0722L};
    for (int c = 0; c < 3; ++c) {
      const long double difference = (long double)(a.pixels[i][c]) - b.pixels[i][c];
      squares += difference * difference;
      mean += weights[c] * difference;
      largest = std::max(largest, std::fabs(difference));
    }
  }
  const io::ImageDifference found = io::differenceOf(a, b);
  EXPECT_NEAR(found.rms, double(std::sqrt(squares / (3 * 13 * 9))), 1e-12);
  EXPECT_NEAR(found.mean, double(mean / (13 * 9)), 1e-12);
  EXPECT_DOUBLE_EQ(found.largest, double(largest));
  EXPECT_EQ(found.rms, io::rmsDifference(a, b));
}

TEST(ImageDifference, OfEqualImagesIsNothing) {
  const Image image = noise(16, 16, 3);
  const io::ImageDifference found = io::differenceOf(image, image);
  EXPECT_EQ(found.rms, 0.0);
  EXPECT_EQ(found.mean, 0.0);
  EXPECT_EQ(found.largest, 0.0);
  EXPECT_EQ(found.perceived, 0.0);
}

TEST(ImageDifference, IsSignedByWhatIsTooDark) {
  const io::ImageDifference darker = io::differenceOf(plain(4, 4, glm::vec3(0.25f)), plain(4, 4, glm::vec3(0.75f)));
  EXPECT_NEAR(darker.mean, -0.5, 1e-7);
  EXPECT_NEAR(darker.rms, 0.5, 1e-7);
}

/// A picture with a bright square, less bright by `less` of its light.
Image square(float less) {
  Image image = plain(64, 64, glm::vec3(0.3f));
  for (int y = 16; y < 48; ++y)
    for (int x = 16; x < 48; ++x)
      image.pixels[std::size_t(64 * y + x)] = glm::vec4(glm::vec3(0.8f * (1.0f - less)), 1.0f);
  return image;
}

TEST(ImageDifference, IsPerceivedTheMoreTheLargerItIs) {
  EXPECT_EQ(io::differenceOf(square(0.0002f), square(0.0f)).perceived, 0.0) << "below a step of PNG";
  EXPECT_LT(io::differenceOf(square(0.005f), square(0.0f)).perceived, 1.0) << "too little to be noticed";
  double before = 1.0;
  for (const float less : {0.05f, 0.1f, 0.2f, 0.4f}) {
    const double perceived = io::differenceOf(square(less), square(0.0f)).perceived;
    EXPECT_GT(perceived, 1.2 * before) << less;
    before = perceived;
  }
}

TEST(ImageDifference, IsPerceivedInImagesOfAnySize) {
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(3, 2), std::pair(8, 8), std::pair(1, 70), std::pair(65, 2)}) {
    const Image bright = plain(width, height, glm::vec3(0.5f)), dark = plain(width, height, glm::vec3(0.1f));
    EXPECT_GT(io::differenceOf(bright, dark).perceived, 10.0) << width << " x " << height;
  }
}

TEST(ImageDifference, NeedsImagesOfOneSize) {
  EXPECT_THROW(io::differenceOf(plain(2, 3, {}), plain(3, 2, {})), Error);
  EXPECT_THROW(io::differencePicture(plain(2, 3, {}), plain(3, 3, {}), 1.0), Error);
  EXPECT_THROW(io::differenceOf(Image{}, Image{}), Error);
}

TEST(DifferencePicture, IsGreyWhereNothingDiffersBlueWhereTooDarkRedWhereTooBright) {
  Image image = plain(5, 1, glm::vec3(0.5f));
  image.pixels[1] -= glm::vec4(0.05f);
  image.pixels[2] += glm::vec4(0.05f);
  image.pixels[3] -= glm::vec4(0.4f);
  image.pixels[4] = glm::vec4(9.0f);
  const Image picture = io::differencePicture(image, plain(5, 1, glm::vec3(0.5f)), 10.0);
  const glm::vec4 none = picture.pixels[0], darker = picture.pixels[1], brighter = picture.pixels[2];
  EXPECT_NEAR(none.r, none.b, 0.02f);
  EXPECT_NEAR(none.g, none.b, 0.02f);
  EXPECT_GT(darker.b, darker.r + 0.1f);
  EXPECT_GT(brighter.r, brighter.b + 0.1f);
  EXPECT_EQ(picture.pixels[3], glm::vec4(io::differenceColor(-1.0), 1.0f)) << "the scale's end";
  EXPECT_EQ(picture.pixels[4], glm::vec4(io::differenceColor(1.0), 1.0f));
  EXPECT_NE(picture.pixels[3], darker);
}

}  // namespace
