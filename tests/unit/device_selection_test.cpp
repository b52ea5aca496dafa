// SPDX-License-Identifier: Apache-2.0
// Choice of devices: a made-up list for the rules, the machine's own devices for opening them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "device/device.hpp"
#include "device/device_list.hpp"

namespace cdsm::device {
namespace {

ListedDevice listed(const std::string& id, const std::string& platform, const std::string& name) {
  ListedDevice device;
  device.description.id = id;
  device.description.platform = platform;
  device.description.name = name;
  device.description.fetch = "buffer";
  return device;
}

std::vector<ListedDevice> threeDevices() {
  std::vector<ListedDevice> devices{listed("0:0", "Old", "Card"), listed("1:0", "Portable", "CPU-Zen"),
                                    listed("1:1", "Portable", "Accelerator 9000")};
  devices[0].description.unusable = "it has no compiler for OpenCL C";
  return devices;
}

std::string errorOf(const std::vector<ListedDevice>& devices, const std::string& spec) {
  try {
    chooseDevice(devices, spec);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ChooseDevice, takesIdsPartsOfNamesAndTheFirstUsable) {
  const auto devices = threeDevices();
  EXPECT_EQ(chooseDevice(devices, "").description.id, "1:0");
  EXPECT_EQ(chooseDevice(devices, "1:1").description.id, "1:1");
  EXPECT_EQ(chooseDevice(devices, "accel").description.id, "1:1");
  EXPECT_EQ(chooseDevice(devices, "PORTABLE").description.id, "1:0");
}

TEST(ChooseDevice, saysWhatExistsAndWhatCannotBeUsed) {
  const std::string unknown = errorOf(threeDevices(), "7:0");
  for (const char* part : {"'7:0'", "0:0 'Card'", "unusable", "1:1 'Accelerator 9000' (Portable)"}) {
    EXPECT_NE(unknown.find(part), std::string::npos) << unknown;
  }
  EXPECT_NE(errorOf(threeDevices(), "card").find("no compiler"), std::string::npos);
  EXPECT_NE(errorOf({}, "").find("no OpenCL device"), std::string::npos);
}

TEST(ResolveFetch, refusesImagesWithoutImagesAndUnknownWords) {
  DeviceDescription device = threeDevices()[1].description;
  EXPECT_EQ(resolveFetch(device, "auto"), "buffer");
  EXPECT_THROW(resolveFetch(device, "image"), Error);
  EXPECT_THROW(resolveFetch(device, "images"), Error);
  device.images = true;
  EXPECT_EQ(resolveFetch(device, "image"), "image");
}

TEST(OpenDevice, opensEveryUsableDeviceOfTheListByItsId) {
  for (const DeviceDescription& description : Device::list()) {
    EXPECT_FALSE(description.name.empty());
    EXPECT_GT(description.maxAllocationBytes, 0u);
    if (!description.unusable.empty()) continue;
    const auto device = Device::open(description.id, "buffer");
    EXPECT_EQ(device->description().name, description.name);
    EXPECT_FALSE(device->fetchImages());
    device->finish();
  }
}

TEST(OpenDevice, refusesUnknownDevicesAndFetches) {
  EXPECT_THROW(Device::open("no such device"), Error);
  EXPECT_THROW(Device::open("99:0"), Error);
  EXPECT_THROW(Device::open("", "pigeon"), Error);
}

}  // namespace
}  // namespace cdsm::device
