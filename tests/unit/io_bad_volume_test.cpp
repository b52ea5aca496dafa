// SPDX-License-Identifier: Apache-2.0
// Volumes that are damaged, lie about their size or are no scalar grid: each gets one line, none a crash or an image.
#include <cstring>
#include <limits>

#include "io/volume_file.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::dataFile;
using cdsm::test::expectError;
using cdsm::test::readBytes;
using cdsm::test::replaced;

class BadVolume : public testing::Test {
 protected:
  /// What reading these bytes under that name says.
  void expectRefused(const std::string& name, const std::string& bytes, const std::string& part, int line = 0) {
    const std::string path = folder.write(name, bytes);
    expectError([&] { io::readVolume(path); }, part, line);
  }
  /// The same for a file of tests/data with one piece of text replaced.
  void expectSpoiled(const std::string& name, const std::string& from, const std::string& to, const std::string& part,
                     int line = 0) {
    expectRefused(name, replaced(readBytes(dataFile(name)), from, to), part, line);
  }

  test::TemporaryFolder folder;
};

TEST_F(BadVolume, MissingEmptyOrNoFileAtAll) {
  expectError([&] { io::readVolume(folder.path("none.nrrd")); }, "no such file");
  expectError([&] { io::readVolume("/dev/zero.nrrd"); }, "no such file");
  std::filesystem::create_directory(folder.path("folder.mha"));
  expectError([&] { io::readVolume(folder.path("folder.mha")); }, "folder");
  for (const char* name :
       {"empty.nrrd", "empty.nhdr", "empty.mhd", "empty.mha", "empty.nii", "empty.nii.gz", "empty.hdr"})
    expectRefused(name, "", "empty");
}

TEST_F(BadVolume, UnknownEndingsAreToldTheKnownOnes) {
  for (const char* name : {"volume.dat", "volume", "volume.gz", "nrrd"})
    expectRefused(name, "bytes", ".nrrd, .nhdr, .mhd, .mha, .nii, .nii.gz, .hdr, .img, .vdb, .vti, .raw and .raw.gz");
}

TEST_F(BadVolume, AnyCutIsNoticed) {
  for (const char* name : {"raw_u8.nrrd", "gzip_i16_big.nrrd", "ascii_u16.nrrd", "local_u8.mha", "local_zlib_u16.mha",
                           "pixdim_u8.nii", "sform_i16.nii.gz"}) {
    const std::string bytes = readBytes(dataFile(name));
    for (std::size_t kept = 1; kept < bytes.size(); ++kept) {
      // The last bytes of an ascii file are a line end and digits; without them it is a good file with other numbers.
      if (std::string(name) == "ascii_u16.nrrd" && kept + 4 > bytes.size()) continue;
      const std::string path = folder.write(name, bytes.substr(0, kept));
      EXPECT_THROW(io::readVolume(path), Error) << name << " cut to " << kept << " bytes";
    }
  }
}

TEST_F(BadVolume, TooManyBytesAreNoticed) {
  for (const char* name : {"raw_u8.nrrd", "local_u8.mha", "pixdim_u8.nii"})
    expectRefused(name, readBytes(dataFile(name)) + "x", "more than");
  expectRefused("ascii_u16.nrrd", readBytes(dataFile("ascii_u16.nrrd")) + " 7", "25 voxels");
}

TEST_F(BadVolume, DamagedCompressionIsNoticed) {
  for (const char* name : {"gzip_i16_big.nrrd", "local_zlib_u16.mha", "sform_i16.nii.gz"}) {
    std::string bytes = readBytes(dataFile(name));
    bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 0x55);  // of the checksum or just before
    const std::string path = folder.write(name, bytes);
    EXPECT_THROW(io::readVolume(path), Error) << name;
  }
}

TEST_F(BadVolume, AbsurdSizesAreRefusedBeforeAllocating) {
  for (const char* sizes : {"100000 100000 100000", "4294967296 4294967296 4294967296",
                            "18446744073709551615 18446744073709551615 2", "2000 2000 2000"}) {
    const std::string path =
        folder.write("gzip_i16_big.nrrd", replaced(readBytes(dataFile("gzip_i16_big.nrrd")), "3 2 4", sizes));
    EXPECT_THROW(io::readVolume(path), Error) << sizes;
    expectSpoiled("local_u8.mha", "3 2 4", sizes, "");
    expectSpoiled("local_zlib_u16.mha", "3 2 4", sizes, "");
  }
  expectSpoiled("raw_u8.nrrd", "3 2 4", "100000 100000 100000", "100000 x 100000 x 100000 voxels");
  expectSpoiled("raw_u8.nrrd", "3 2 4", "1000 1000 1000", "fewer than the 1000000000 bytes");
}

TEST_F(BadVolume, ZeroAndNegativeSizes) {
  expectSpoiled("raw_u8.nrrd", "3 2 4", "3 0 4", "");
  expectSpoiled("raw_u8.nrrd", "3 2 4", "3 -2 4", "");
  expectSpoiled("local_u8.mha", "3 2 4", "3 0 4", "at least 1");
  expectSpoiled("local_u8.mha", "3 2 4", "3 -2 4", "not a number", 3);
  for (const char side : {'\0', '\xff'}) {
    std::string bytes = readBytes(dataFile("pixdim_u8.nii"));
    bytes[44] = bytes[45] = side;  // dim[2], two bytes
    expectRefused("size.nii", bytes, "at least 1");
  }
}

TEST_F(BadVolume, WrongSizesDoNotMatchTheData) {
  expectSpoiled("raw_u8.nrrd", "3 2 4", "3 2 5", "fewer than");
  expectSpoiled("gzip_i16_big.nrrd", "3 2 4", "3 2 5", "fewer than");
  expectSpoiled("gzip_i16_big.nrrd", "3 2 4", "3 2 3", "more than");
  expectSpoiled("local_zlib_u16.mha", "3 2 4", "3 2 3", "more than");
  expectSpoiled("local_u8.mha", "3 2 4", "3 2", "3 are needed", 3);
}

TEST_F(BadVolume, MoreThanOneScalarGrid) {
  expectError([&] { io::readVolume(dataFile("time_u8.nii")); }, "2 time steps");
  expectSpoiled("list_axis_u8.nrrd", "1 3 2 4", "2 3 2 2", "4 dimensions");
  expectSpoiled("local_u8.mha", "ElementType", "ElementNumberOfChannels = 3\nElementType", "3 components", 4);
  expectSpoiled("local_u8.mha", "NDims = 3\nDimSize = 3 2 4", "NDims = 4\nDimSize = 3 2 2 2", "time step", 3);
  expectSpoiled("local_u8.mha", "NDims = 3", "NDims = 2", "2 dimensions", 2);
  std::string colours = readBytes(dataFile("pixdim_u8.nii"));
  colours[70] = '\x80';  // datatype 128: RGB
  expectRefused("rgb.nii", colours, "one real number per voxel");
}

TEST_F(BadVolume, SpacesThatAreNone) {
  expectSpoiled("raw_u8.nrrd", "(0.5,0,0) (0,0,1)", "(0.5,0,0) (1,0,0)", "span no space");
  expectSpoiled("raw_u8.nrrd", "(0.5,0,0) (0,0,1)", "(0,0,0) (0,0,1)", "span no space");
  expectSpoiled("raw_u8.nrrd", "(0.5,0,0) (0,0,1)", "none (0,0,1)", "no space direction");
  expectSpoiled("local_u8.mha", "0 1 0 -1 0 0 0 0 1", "0 1 0 0 1 0 0 0 1", "span no space");
  expectSpoiled("local_u8.mha", "ElementSpacing = 0.5", "ElementSpacing = 0", "span no space");
  expectSpoiled("local_u8.mha", "ElementSpacing = 0.5", "ElementSpacing = nan", "span no space");
  expectSpoiled("local_u8.mha", "Offset = 10", "Offset = 1e39", "not finite");
}

/// A grid of 2 x 2 x 2 as MetaImage.
template <typename T>
std::string tinyMetaImage(const std::string& type, T last) {
  const T values[8] = {0, 1, 2, 3, 4, last, last, 7};
  std::string data(sizeof(values), '\0');
  std::memcpy(data.data(), values, sizeof(values));
  return "NDims = 3\nDimSize = 2 2 2\nElementType = " + type + "\nElementDataFile = LOCAL\n" + data;
}

TEST_F(BadVolume, VoxelsThatAreNotFiniteAreNamed) {
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    expectRefused("float.mha", tinyMetaImage<float>("MET_FLOAT", value), "voxel (1, 0, 1) is not a finite number");
    expectRefused("double.mha", tinyMetaImage<double>("MET_DOUBLE", value), "voxel (1, 0, 1) is not a finite number");
  }
  std::string bytes = readBytes(dataFile("qform_f32_big.img"));
  bytes.replace(4, 4, "\x7f\xc0\0\0", 4);
  folder.write("pair.hdr", readBytes(dataFile("qform_f32_big.hdr")));
  expectRefused("pair.img", bytes, "voxel (1, 0, 0) is not a finite number");
}

TEST_F(BadVolume, NumbersThatNoFloatHoldsAreNamed) {
  expectRefused("i.mha", tinyMetaImage<std::int32_t>("MET_INT", -16777217), "voxel (1, 0, 1) holds -16777217");
  expectRefused("u.mha", tinyMetaImage<std::uint64_t>("MET_ULONG_LONG", UINT64_MAX), "18446744073709551615");
  expectRefused("d.mha", tinyMetaImage<double>("MET_DOUBLE", 1e39), "voxel (1, 0, 1) holds");
  const auto kept = io::readVolume(folder.write("k.mha", tinyMetaImage<std::int64_t>("MET_LONG_LONG", INT64_MIN)));
  float value;
  std::memcpy(&value, kept->voxels.data() + 5 * sizeof(float), sizeof(float));
  EXPECT_EQ(value, -9223372036854775808.0f);
}

TEST_F(BadVolume, HeadersThatMakeNoSense) {
  expectRefused("text.nrrd", "hello", "must begin with NRRD");
  expectSpoiled("raw_u8.nrrd", "type: uchar", "type: colour", "teem");
  expectSpoiled("raw_u8.nrrd", "encoding: raw", "encoding: hex", "encoding hex");
  expectSpoiled("ascii_u16.nrrd", "312", "70000", "number 24");
  expectSpoiled("detached_f32.nhdr", "data file: detached_f32.raw", "data file: none.raw", "");
  expectSpoiled("detached_f32.nhdr", "data file: detached_f32.raw", "data file: part%d.raw 1 2 1", "");
  expectRefused("text.mha", "hello\n", "Key = value", 1);
  expectSpoiled("local_u8.mha", "MET_UCHAR", "MET_STRING", "ElementType MET_STRING", 4);
  expectSpoiled("local_u8.mha", "LOCAL", "LIST", "list of files", 8);
  expectSpoiled("local_u8.mha", "LOCAL", "none.raw", "no such file");
  expectSpoiled("local_u8.mha", "ObjectType = Image", "ObjectType = Tube", "Image is needed", 1);
  expectSpoiled("local_u8.mha", "ObjectType = Image", "BinaryData = False", "as text", 1);
  expectSpoiled("local_u8.mha", "ObjectType = Image", "CompressedData = perhaps", "neither True nor False", 1);
  expectRefused("noise.nii", std::string(1000, 'x'), "NIfTI-1");
  expectRefused("lonely.hdr", readBytes(dataFile("qform_f32_big.hdr")), "no such file");
}

TEST_F(BadVolume, ReadersPrintNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  expectRefused("noise.nii", std::string(1000, 'x'), "NIfTI-1");
  expectRefused("short.nii", readBytes(dataFile("pixdim_u8.nii")).substr(0, 300), "NIfTI-1");
  expectSpoiled("raw_u8.nrrd", "type: uchar", "type: colour", "teem");
  expectRefused("lonely.hdr", readBytes(dataFile("qform_f32_big.hdr")), "no such file");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
