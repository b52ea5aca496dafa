// SPDX-License-Identifier: Apache-2.0
// In: an image and its reference, linear and of one size. Out: how far they are apart, in numbers and as a picture.
#pragma once

#include <cdsm/cdsm.hpp>

namespace cdsm::io {

struct ImageDifference {
  double rms = 0.0;        ///< root mean square over pixels and channels of linear RGB
  double mean = 0.0;       ///< of luminances, image less reference: below 0 is too dark
  double largest = 0.0;    ///< absolute, of a channel of a pixel
  double perceived = 0.0;  ///< 3-norm of what a person perceives in each pixel; 1: just noticeable
};

/// Throws Error if the sizes differ. What is perceived is Butteraugli's, as libjxl computes it: a model of the eye's
/// receptors, of contrast at several scales and of masking, here of the images as PNG on a display of 100 cd/m^2.
ImageDifference differenceOf(const Image& image, const Image& reference);

/// ImageDifference::rms alone.
double rmsDifference(const Image& image, const Image& reference);

/// Linear RGB for a signed difference of luminances: blue for -1 and below, light grey for 0, red for 1 and above, in
/// steps that look equal ("cool to warm" [Moreland 2009]).
glm::vec3 differenceColor(double part);

/// The differences of the luminances, times `factor`, in those colours.
Image differencePicture(const Image& image, const Image& reference, double factor);

}  // namespace cdsm::io
