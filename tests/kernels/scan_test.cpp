// SPDX-License-Identifier: Apache-2.0
// Prefix sums on the device against std::exclusive_scan.
#include <gtest/gtest.h>

#include <numeric>

#include "device/scan.hpp"
#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::kernels {
namespace {

using Uints = device::Buffer<std::uint32_t>;

std::vector<std::uint32_t> randomValues(std::size_t count, std::uint32_t seed) {
  reference::Random random(seed);
  std::vector<std::uint32_t> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(std::uint32_t(random.integer(0, 4000)));
  return values;
}

class ScanSizes : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ScanSizes, equalExclusiveSums) {
  const std::size_t count = GetParam();
  std::vector<std::uint32_t> expected = randomValues(count, std::uint32_t(count));
  const Uints values = Uints::fromHost(deviceOf(), expected, "values");
  Uints sums(deviceOf(), count + 1, "sums");
  sums.fill(0xdeadbeefu);
  expected.push_back(0);
  std::exclusive_scan(expected.begin(), expected.end(), expected.begin(), 0u);
  device::Scan scan(deviceOf());
  EXPECT_EQ(scan(count, values, sums), expected.back());
  EXPECT_EQ(sums.download(), expected);
}

INSTANTIATE_TEST_SUITE_P(All, ScanSizes, ::testing::Values(0, 1, 2, 1023, 1024, 1025, 2048, 100000, 1048577));

TEST(Scan, isReusableForSmallerAndLargerArrays) {
  device::Scan scan(deviceOf());
  for (const std::size_t count : {5000u, 3u, 70000u, 0u, 1024u}) {
    const std::vector<std::uint32_t> host = randomValues(count, 7);
    const Uints values = Uints::fromHost(deviceOf(), host, "values");
    Uints sums(deviceOf(), count + 1, "sums");
    EXPECT_EQ(scan(count, values, sums), std::accumulate(host.begin(), host.end(), 0u)) << count;
  }
}

TEST(Scan, refusesSumsThatItsNumbersCannotHold) {
  device::Scan scan(deviceOf());
  for (const std::size_t count : {5u, 5000u}) {
    const Uints values = Uints::fromHost(deviceOf(), std::vector<std::uint32_t>(count, 0x40000000u), "values");
    Uints sums(deviceOf(), count + 1, "sums");
    EXPECT_THROW(scan(count, values, sums), DeviceError) << count;
  }
}

}  // namespace
}  // namespace cdsm::kernels
