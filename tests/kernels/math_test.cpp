// SPDX-License-Identifier: Apache-2.0
// Error bounds of common/math.clh against double precision, both batch widths.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::kernels {
namespace {

const char* const kText = R"(
#include "common/math.clh"
__kernel void exponentials(__global const float* x, __global float* batch, __global float* single) {
  size_t i = get_global_id(0);
  vstoreN(exp2Batch(vloadN(i, x)), i, batch);
  for (int k = 0; k < CDSM_BATCH; ++k) single[i * CDSM_BATCH + k] = exp2Fast(x[i * CDSM_BATCH + k]);
}
__kernel void logarithms(__global const float* x, __global float* logs) {
  size_t i = get_global_id(0);
  vstoreN(log2Batch(vloadN(i, x)), i, logs);
}
)";

using Floats = device::Buffer<float>;

class Math : public ::testing::TestWithParam<int> {
 protected:
  device::Device& device_ = deviceOf();
  const cl::Program& program() { return testProgram(device_, kText, {{"CDSM_BATCH", std::to_string(GetParam())}}); }
  std::size_t batches(const std::vector<float>& x) const { return x.size() / std::size_t(GetParam()); }

  /// Of exp2Batch and of exp2Fast.
  std::pair<std::vector<float>, std::vector<float>> exponentials(const std::vector<float>& x) {
    const Floats in = Floats::fromHost(device_, x, "x");
    Floats batch(device_, x.size(), "exponentials"), single(device_, x.size(), "exponentials one by one");
    device::Kernel<Floats, Floats, Floats> kernel(device_, program(), "exponentials");
    kernel({"exponentials", {batches(x)}, {1}}, in, batch, single);
    return {batch.download(), single.download()};
  }

  std::vector<float> logarithms(const std::vector<float>& x) {
    const Floats in = Floats::fromHost(device_, x, "x");
    Floats out(device_, x.size(), "logarithms");
    device::Kernel<Floats, Floats> kernel(device_, program(), "logarithms");
    kernel({"logarithms", {batches(x)}, {1}}, in, out);
    return out.download();
  }
};

/// Evenly in [-126, 126], densely around 0 and at the places where the whole part changes.
std::vector<float> exponents() {
  std::vector<float> x;
  for (int i = 0; i < 8192; ++i) x.push_back(-126.0f + 252.0f * float(i) / 8191.0f);
  for (int i = 0; i < 2048; ++i) x.push_back(-2.0f + 4.0f * float(i) / 2047.0f);
  for (int i = -126; i < 126; ++i)
    for (const float half : {0.5f, 0.49999997f, 0.50000006f, 1.0f}) x.push_back(float(i) + half);
  while (x.size() % 8 != 0) x.push_back(0.0f);
  return x;
}

TEST_P(Math, exponentialsStayWithinTheirRelativeError) {
  const std::vector<float> x = exponents();
  const auto [batch, single] = exponentials(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double exact = std::exp2(double(x[i]));
    EXPECT_NEAR(batch[i] / exact, 1.0, 3e-7) << "exp2Batch(" << x[i] << ")";
    EXPECT_NEAR(single[i] / exact, 1.0, 3e-7) << "exp2Fast(" << x[i] << ")";
  }
}

TEST_P(Math, exponentialsAreClampedOutside) {
  const std::vector<float> x{-127.0f, -1e4f, -INFINITY, -126.5f, 127.0f, 1e4f, INFINITY, 126.5f};
  const auto [batch, single] = exponentials(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const float edge = i < 4 ? std::exp2(-126.0f) : std::exp2(126.0f);
    EXPECT_EQ(batch[i], edge) << x[i];
    EXPECT_EQ(single[i], edge) << x[i];
  }
}

/// The error of the series, and half a unit in the last place of a sum with the exponent.
double logarithmError(double exact) { return 2e-7 + 6e-8 * std::abs(exact); }

TEST_P(Math, logarithmsStayWithinTheirAbsoluteError) {
  std::vector<float> x;
  reference::Random random(3);
  for (int i = 0; i < 8192; ++i) x.push_back(float(std::exp2(random.uniform(-125.9, 127.9))));
  for (int i = 0; i < 4096; ++i) x.push_back(float(random.uniform(0.5, 2.0)));
  for (const float special : {1.0f, 0.99999994f, 1.0000001f, 1e-20f, 0.70710677f, 0.70710683f, 1.4142135f, 1.4142137f})
    x.push_back(special);
  const std::vector<float> logs = logarithms(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double exact = std::log2(double(x[i]));
    EXPECT_NEAR(logs[i], exact, logarithmError(exact)) << "log2Batch(" << x[i] << ")";
  }
  EXPECT_EQ(logs[x.size() - 8], 0.0f) << "log2Batch(1)";
}

TEST_P(Math, powersOfHighlightsAgreeWithPow) {
  std::vector<float> x;
  for (int i = 1; i <= 4096; ++i) x.push_back(float(i) / 4096.0f);
  const std::vector<float> logs = logarithms(x);
  for (const float shininess : {1.0f, 10.0f, 100.0f})
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(std::exp2(double(shininess) * logs[i]), std::pow(double(x[i]), double(shininess)), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Widths, Math, ::testing::Values(4, 8), ::testing::PrintToStringParamName());

}  // namespace
}  // namespace cdsm::kernels
