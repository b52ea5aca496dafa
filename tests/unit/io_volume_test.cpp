// SPDX-License-Identifier: Apache-2.0
// Every volume format on the grids of tests/data/make_data.py: values, types and places in space by hand.
#include "io/volume_file.hpp"

#include <cstring>

#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::dataFile;

constexpr glm::uvec3 kSize(3, 2, 4);

template <typename T>
double valueAt(const VolumeData& volume, std::size_t index) {
  T value;
  std::memcpy(&value, volume.voxels.data() + index * sizeof(T), sizeof(T));
  return static_cast<double>(value);
}

/// Voxel (x, y, z) of the file holds (x + 10 y + zStep z + offset) * factor.
struct Grid {
  const char* file;
  VoxelType type;
  double zStep, offset, factor;
};

void PrintTo(const Grid& grid, std::ostream* out) { *out << grid.file; }

class VolumeFormats : public testing::TestWithParam<Grid> {};

TEST_P(VolumeFormats, HoldTheFilesOwnValues) {
  const Grid& grid = GetParam();
  const auto volume = io::readVolume(dataFile(grid.file));
  EXPECT_EQ(volume->type, grid.type);
  ASSERT_EQ(volume->size, kSize);
  ASSERT_EQ(volume->voxels.size(), 24 * voxelBytes(grid.type));
  double (*const values[])(const VolumeData&, std::size_t) = {
      valueAt<std::uint8_t>, valueAt<std::int8_t>, valueAt<std::uint16_t>, valueAt<std::int16_t>, valueAt<float>};
  for (unsigned z = 0; z < 4; ++z)
    for (unsigned y = 0; y < 2; ++y)
      for (unsigned x = 0; x < 3; ++x) {
        const double expected = (x + 10.0 * y + grid.zStep * z + grid.offset) * grid.factor;
        // Tenths of doubles become the nearest float, all else is exact.
        EXPECT_EQ(values[static_cast<int>(volume->type)](*volume, x + 3 * (y + 2 * z)),
                  grid.type == VoxelType::Float32 ? static_cast<double>(static_cast<float>(expected)) : expected)
            << x << " " << y << " " << z;
      }
}

INSTANTIATE_TEST_SUITE_P(
    All, VolumeFormats,
    testing::Values(
        Grid{"raw_u8.nrrd", VoxelType::UInt8, 60, 0, 1}, Grid{"gzip_i16_big.nrrd", VoxelType::Int16, 100, -150, 1},
        Grid{"detached_f32.nhdr", VoxelType::Float32, 100, 0, 0.25},
        Grid{"ascii_u16.nrrd", VoxelType::UInt16, 100, 0, 1}, Grid{"list_axis_u8.nrrd", VoxelType::UInt8, 60, 0, 1},
        Grid{"local_u8.mha", VoxelType::UInt8, 60, 0, 1}, Grid{"beside_i16_big.mhd", VoxelType::Int16, 100, -150, 1},
        Grid{"beside_zlib_f32.mhd", VoxelType::Float32, 100, 0, 0.25},
        Grid{"local_zlib_u16.mha", VoxelType::UInt16, 100, 0, 1}, Grid{"local_i8.mha", VoxelType::Int8, 60, -128, 1},
        Grid{"local_i32.mha", VoxelType::Float32, 100, -150, 1048576},
        Grid{"local_f64.mha", VoxelType::Float32, 100, 0, 0.1}, Grid{"pixdim_u8.nii", VoxelType::UInt8, 60, 0, 1},
        Grid{"sform_i16.nii.gz", VoxelType::Int16, 100, -150, 1},
        Grid{"qform_f32_big.hdr", VoxelType::Float32, 100, 0, 0.25},
        Grid{"qform_f32_big.img", VoxelType::Float32, 100, 0, 0.25},
        Grid{"grid_3x2x4_uint8.raw", VoxelType::UInt8, 60, 0, 1},
        Grid{"grid_3x2x4_int16.raw.gz", VoxelType::Int16, 100, -150, 1},
        Grid{"ascii_u16.vti", VoxelType::UInt16, 100, 0, 1}, Grid{"inline_i16_big.vti", VoxelType::Int16, 100, -150, 1},
        Grid{"inline_zlib_f64.vti", VoxelType::Float32, 100, 0, 0.1},
        Grid{"appended_f32.vti", VoxelType::Float32, 100, 0, 0.25},
        Grid{"appended_zlib_u8.vti", VoxelType::UInt8, 60, 0, 1}, Grid{"series", VoxelType::Int16, 100, -150, 1}));

/// Where voxel (0, 0, 0) lies and the steps from voxel to voxel along x, y and z.
void expectPlace(const char* file, glm::vec3 origin, glm::vec3 x, glm::vec3 y, glm::vec3 z) {
  const glm::mat4 matrix = io::readVolume(dataFile(file))->objectFromIndex;
  EXPECT_EQ(matrix[0], glm::vec4(x, 0.0f)) << file;
  EXPECT_EQ(matrix[1], glm::vec4(y, 0.0f)) << file;
  EXPECT_EQ(matrix[2], glm::vec4(z, 0.0f)) << file;
  EXPECT_EQ(matrix[3], glm::vec4(origin, 1.0f)) << file;
}

TEST(VolumePlaces, NrrdTakesSpaceDirectionsAndOrigin) {
  expectPlace("raw_u8.nrrd", {10, 20, 30}, {0.5f, 0, 0}, {0, 0, 1}, {0, -2, 0});
}

TEST(VolumePlaces, NrrdTakesSpacingsAndOneWhereThereIsNone) {
  expectPlace("gzip_i16_big.nrrd", {0, 0, 0}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 2});
  expectPlace("ascii_u16.nrrd", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
}

TEST(VolumePlaces, MetaImageTakesTransformSpacingAndOffset) {
  expectPlace("local_u8.mha", {10, 20, 30}, {0, 0.5f, 0}, {-1, 0, 0}, {0, 0, 2});
  expectPlace("local_i8.mha", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
}

TEST(VolumePlaces, NiftiTakesSformThenQformThenPixdim) {
  expectPlace("sform_i16.nii.gz", {10, 20, 30}, {0, 0.5f, 0}, {-1, 0, 0}, {0, 0, 2});
  expectPlace("qform_f32_big.hdr", {10, 20, 30}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 2});
  expectPlace("pixdim_u8.nii", {0, 0, 0}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 2});
}

TEST(VolumePlaces, RawLiesAtTheOriginWithEdgesOfOne) {
  expectPlace("grid_3x2x4_uint8.raw", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
}

TEST(VolumePlaces, VtiTakesOriginSpacingDirectionAndExtent) {
  expectPlace("ascii_u16.vti", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  expectPlace("appended_f32.vti", {10, 20, 30}, {0.5f, 0, 0}, {0, 1, 0}, {0, 0, 2});
  expectPlace("inline_i16_big.vti", {10, 20, 30}, {0, 0.5f, 0}, {-1, 0, 0}, {0, 0, 2});
  const test::TemporaryFolder folder;
  std::string text = test::readBytes(dataFile("inline_i16_big.vti"));
  for (int i = 0; i < 2; ++i) text = test::replaced(text, "0 2 0 1 0 3", "4 6 -1 0 0 3");
  expectPlace(folder.write("extent.vti", text).c_str(), {11, 22, 30}, {0, 0.5f, 0}, {-1, 0, 0}, {0, 0, 2});
}

TEST(VolumePlaces, DicomTakesPositionOrientationAndSpacing) {
  expectPlace("series", {10, 20, 30}, {0, 0.5f, 0}, {-1, 0, 0}, {0, 0, 2});
}

TEST(VolumeParts, ArraysOfVtiAreChosenByName) {
  EXPECT_EQ(io::readVolume(dataFile("appended_f32.vti"), {"", "other"})->type, VoxelType::UInt8);
  EXPECT_EQ(io::readVolume(dataFile("inline_zlib_f64.vti"))->type, VoxelType::Float32);
  test::expectError(
      [] {
        io::readVolume(dataFile("appended_f32.vti"), {"", "smoke"});
      },
      "has no point data \"smoke\"; name one with array = \"...\", its arrays of points are: \"other\", "
      "\"grid\"");
}

TEST(VolumeParts, AreRefusedWhereThereIsOne) {
  EXPECT_THROW(io::readVolume(dataFile("raw_u8.nrrd"), {"density", ""}), Error);
  EXPECT_THROW(io::readVolume(dataFile("raw_u8.nrrd"), {"", "density"}), Error);
  EXPECT_THROW(io::readVolume(dataFile("ascii_u16.vti"), {"density", ""}), Error);
}

}  // namespace
