// SPDX-License-Identifier: Apache-2.0
// Host and device mean the same bytes by every field of every shared struct: generated kernels write and read them all.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "kernel_test.hpp"
#include "struct_fields.hpp"

namespace cdsm::kernels {
namespace {

using Bytes = std::vector<std::byte>;
using Uints = device::Buffer<std::uint32_t>;

/// The value of number i, the same for both sides: distinct, exact as a float, never the pattern of a neighbour.
float valueOf(std::size_t i) { return 3.0f + 2.0f * float(i); }

/// writeFields: every field gets its value. readFields: every field, converted to its value, in the order of the table.
std::string kernelText(const SharedStruct& type) {
  std::ostringstream text;
  text << "#include \"" << type.header << "\"\n__kernel void writeFields(__global " << type.name << "* s) {\n";
  for (std::size_t i = 0; i < type.scalars.size(); ++i)
    text << "  s[1]" << type.scalars[i].path << " = " << std::size_t(valueOf(i)) << ";\n";
  text << "}\n__kernel void readFields(" << type.name << " s, __global uint* values, __global uint* bytes) {\n"
       << "  *bytes = sizeof(" << type.name << ");\n";
  for (std::size_t i = 0; i < type.scalars.size(); ++i)
    text << "  values[" << i << "] = (uint)s" << type.scalars[i].path << ";\n";
  text << "}\n";
  return text.str();
}

/// A struct filled by the host, number by number.
Bytes filledStruct(const SharedStruct& type) {
  Bytes bytes(type.bytes, std::byte(0xff));
  for (std::size_t i = 0; i < type.scalars.size(); ++i) {
    const float number = valueOf(i);
    const auto whole = std::uint32_t(number);
    const void* source = type.scalars[i].isFloat ? static_cast<const void*>(&number) : &whole;
    std::memcpy(bytes.data() + type.scalars[i].offset, source, sizeof(float));
  }
  return bytes;
}

class SharedStructs : public ::testing::TestWithParam<std::size_t> {
 protected:
  SharedStruct type_ = sharedStructs()[GetParam()];
  device::Device& device_ = deviceOf();
  const cl::Program& program() { return testProgram(device_, kernelText(type_)); }
};

TEST_P(SharedStructs, areFilledByTheirFields) {
  std::set<std::size_t> offsets;
  for (const Scalar& scalar : type_.scalars) offsets.insert(scalar.offset);
  EXPECT_EQ(offsets.size() * sizeof(float), type_.bytes) << "struct_fields.cpp lacks a field of " << type_.name;
}

TEST_P(SharedStructs, travelFromDeviceToHost) {
  device::Buffer<std::byte> structs(device_, 2 * type_.bytes, "two structs");
  structs.fill(std::byte(0xff));
  device::Kernel<device::Buffer<std::byte>> writeFields(device_, program(), "writeFields");
  writeFields({"write fields", {1}, {1}}, structs);
  const Bytes expected = filledStruct(type_), second = structs.download(device::kAll, type_.bytes);
  for (const Scalar& scalar : type_.scalars)
    EXPECT_EQ(std::memcmp(&second[scalar.offset], &expected[scalar.offset], 4), 0) << type_.name << scalar.path;
  EXPECT_EQ(structs.download(type_.bytes), Bytes(type_.bytes, std::byte(0xff))) << "the struct before it changed";
}

TEST_P(SharedStructs, travelFromHostToDevice) {
  Uints values(device_, type_.scalars.size(), "values"), bytes(device_, 1, "bytes");
  cl::Kernel kernel(program(), "readFields");
  const Bytes filled = filledStruct(type_);
  ASSERT_EQ(clSetKernelArg(kernel(), 0, filled.size(), filled.data()), CL_SUCCESS) << type_.name;
  kernel.setArg(1, values.cl());
  kernel.setArg(2, bytes.cl());
  device_.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
  EXPECT_EQ(bytes.read(0), type_.bytes);
  const std::vector<std::uint32_t> read = values.download();
  for (std::size_t i = 0; i < read.size(); ++i)
    EXPECT_EQ(read[i], std::uint32_t(valueOf(i))) << type_.name << type_.scalars[i].path;
}

INSTANTIATE_TEST_SUITE_P(All, SharedStructs, ::testing::Range<std::size_t>(0, sharedStructs().size()),
                         [](const auto& instance) { return sharedStructs()[instance.param].name; });

TEST(SharedHeaders, haveNoStructThatIsNotTested) {
  std::set<std::string> tested;
  for (const SharedStruct& type : sharedStructs()) tested.insert(type.name);
  for (const char* name : {"bvh", "frame", "layer", "map", "scene", "view"}) {
    std::ifstream file(CDSM_KERNEL_FOLDER "/shared/" + std::string(name) + "_data.h");
    ASSERT_TRUE(file) << name;
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::regex pattern("typedef struct (\\w+)");
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
      EXPECT_EQ(tested.count((*it)[1]), 1u) << (*it)[1];
  }
}

}  // namespace
}  // namespace cdsm::kernels
