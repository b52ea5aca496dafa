// SPDX-License-Identifier: Apache-2.0
// Raw, VTI and DICOM files that are damaged, lie about their size or are no scalar grid.
#include "io/volume_file.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::dataFile;
using cdsm::test::expectError;
using cdsm::test::readBytes;
using cdsm::test::replaced;

class BadFormats : public testing::Test {
 protected:
  void expectRefused(const std::string& name, const std::string& bytes, const std::string& part, int line = 0) {
    const std::string path = folder.write(name, bytes);
    expectError([&] { io::readVolume(path); }, part, line);
  }
  void expectSpoiled(const std::string& name, const std::string& from, const std::string& to, const std::string& part,
                     int line = 0) {
    expectRefused(name, replaced(readBytes(dataFile(name)), from, to), part, line);
  }
  /// The series of tests/data, its slice of that number (0: lowest) with a piece of text replaced.
  void expectSpoiledSlice(int slice, const std::string& from, const std::string& to, const std::string& part) {
    std::filesystem::create_directory(folder.path("series"));
    for (int z = 0; z < 4; ++z) {
      const std::string name = "series/" + std::to_string(9 - z) + ".dcm";
      const std::string bytes = readBytes(dataFile(name));
      folder.write(name, z == slice ? replaced(bytes, from, to) : bytes);
    }
    expectError([&] { io::readVolume(folder.path("series")); }, part);
  }

  test::TemporaryFolder folder;
};

TEST_F(BadFormats, RawFilesMustSayTheirSizeInTheirNames) {
  for (const char* name : {"grid.raw", "grid_2x2_uint8.raw", "grid_2x2x2.raw", "grid_2x2x2_colour.raw", ".raw",
                           "grid_2x2x-2_uint8.raw", "grid_axbxc_uint8.raw", "grid_2x2x2x2_uint8.raw", "x.raw.gz"})
    expectRefused(name, "12345678", "no size and type in its name");
  expectRefused("grid_2x2x2_uint8.raw", "1234567", "fewer than the 8 bytes");
  expectRefused("grid_2x2x2_uint8.raw", "123456789", "more than the 8 bytes");
  expectRefused("grid_0x2x2_uint8.raw", "1", "at least 1");
  expectRefused("grid_100000x100000x100000_uint8.raw", "1", "at most 2^34 voxels");
  expectRefused("grid_2000x2000x2000_float64.raw", "1", "fewer than");
  expectRefused("grid_2000x2000x2000_uint8.raw.gz", readBytes(dataFile("grid_3x2x4_int16.raw.gz")), "fewer than");
  expectRefused("grid_1x1x1_float32.raw", std::string("\0\0\xc0\x7f", 4), "not a finite number");
}

TEST_F(BadFormats, AnyCutOfVtiIsNoticed) {
  for (const char* name :
       {"ascii_u16.vti", "inline_i16_big.vti", "inline_zlib_f64.vti", "appended_f32.vti", "appended_zlib_u8.vti"}) {
    const std::string bytes = readBytes(dataFile(name));
    for (std::size_t kept = 1; kept + 1 < bytes.size(); kept += 5) {  // the last line end is not needed
      const std::string path = folder.write(name, bytes.substr(0, kept));
      EXPECT_THROW(io::readVolume(path), Error) << name << " cut to " << kept << " bytes";
    }
  }
}

TEST_F(BadFormats, VtiThatClaimsOtherSizes) {
  for (const char* name :
       {"ascii_u16.vti", "inline_i16_big.vti", "inline_zlib_f64.vti", "appended_f32.vti", "appended_zlib_u8.vti"})
    for (const char* extent :
         {"0 2 0 1 0 4", "0 2 0 1 0 2", "0 2 0 1 3 0", "0 99999 0 99999 0 99999", "0 1999 0 1999 0 1999",
          "0 2147483647 0 2147483647 0 3", "-2147483648 2147483647 0 1 0 3"}) {
      const std::string bytes = replaced(readBytes(dataFile(name)), "0 2 0 1 0 3", extent);
      const std::string path = folder.write(name, replaced(bytes, "0 2 0 1 0 3", extent));
      EXPECT_THROW(io::readVolume(path), Error) << name << " " << extent;
    }
  expectSpoiled("ascii_u16.vti", "0 2 0 1 0 3", "0 2 0 1", "must be 6 numbers", 3);
  expectSpoiled("ascii_u16.vti", "0 2 0 1 0 3", "0 2 0 1 0 4", "of another Extent", 4);
}

TEST_F(BadFormats, VtiWithDamagedData) {
  expectSpoiled("ascii_u16.vti", "312", "70000", "number 24");
  expectSpoiled("ascii_u16.vti", "312", "312 313", "25 voxels");
  expectSpoiled("inline_i16_big.vti", "AAAA", "AA*A", "base64");
  expectSpoiled("inline_i16_big.vti", "AAAA", "BBBB", "an array of");
  expectSpoiled("inline_zlib_f64.vti", "eJx", "xxx", "damaged in block 0");
  expectSpoiled("inline_zlib_f64.vti", "\"binary\" >A", "\"binary\" >/", "blocks make no sense");
  expectSpoiled("appended_f32.vti", "offset=\"28\"", "offset=\"99999\"", "offset is \"99999\"", 7 - 1);
  expectSpoiled("appended_f32.vti", "offset=\"28\"", "offset=\"-1\"", "offset is \"-1\"");
  expectSpoiled("appended_f32.vti", "offset=\"28\"", "offset=\"27\"", "");
  expectSpoiled("appended_f32.vti", "encoding=\"raw\"", "encoding=\"hex\"", "raw or base64");
}

TEST_F(BadFormats, VtiThatIsNoScalarGridOfPoints) {
  const std::string name = "inline_i16_big.vti";
  expectRefused("text.vti", "hello", "XML", 1);
  expectRefused("nested.vti", std::string(200000, '<'), "XML", 1);
  expectSpoiled(name, "<VTKFile type=\"ImageData\"", "<VTKFile type=\"PolyData\"", "type ImageData", 2);
  expectSpoiled(name, "BigEndian", "Middle", "byte_order is \"Middle\"", 2);
  expectSpoiled(name, "byte_order", "header_type=\"Int8\" byte_order", "header_type is \"Int8\"", 2);
  expectSpoiled(name, "byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order", "vtkLZ4DataCompressor", 2);
  expectSpoiled(name, "format=", "NumberOfComponents=\"3\" format=", "\"3\" components", 6);
  expectSpoiled(name, "type=\"Int16\"", "type=\"String\"", "type is \"String\"", 6);
  expectSpoiled(name, "format=\"binary\"", "format=\"secret\"", "format is \"secret\"", 6);
  expectSpoiled(name, "Scalars=\"grid\"", "Scalars=\"smoke\"><DataArray Name=\"a\"/", "its arrays of points are");
  expectSpoiled(name, "</Piece>", "</Piece><Piece/>", "second Piece");
  expectSpoiled(name, "Spacing=\"0.5", "Spacing=\"0", "span no space");
  expectSpoiled(name, "Spacing=\"0.5", "Spacing=\"wide", "Spacing is");
  std::string cells = replaced(readBytes(dataFile(name)), "<CellData/>", "");
  cells = replaced(replaced(cells, "<PointData", "<CellData"), "</PointData", "</CellData");
  expectRefused("cells.vti", cells, "cell data alone", 4);
}

TEST_F(BadFormats, DicomSeriesThatAreNoGrid) {
  expectError([&] { io::readVolume(folder.path("")); }, "folder with 0 DICOM files");
  expectError([&] { io::readVolume(dataFile("series/6.dcm")); }, "one slice of a DICOM series");
  expectSpoiledSlice(2, "10\\20\\34", "10\\20\\35", "evenly spaced");
  expectSpoiledSlice(2, "10\\20\\34", "10\\20\\32", "evenly spaced");
  expectSpoiledSlice(3, "10\\20\\36", "11\\20\\36", "gantry tilt");
  expectSpoiledSlice(1, "0\\1\\0\\-1\\0\\0", "1\\0\\0\\0\\1\\0 ", "another orientation");
  expectSpoiledSlice(1, "0\\1\\0\\-1\\0\\0", "0\\1\\0\\-1\\1\\0", "right angle");
  expectSpoiledSlice(1, "1\\0.5", "2\\0.5", "another PixelSpacing");
  expectSpoiledSlice(1, "1\\0.5", "0\\0.5", "PixelSpacing is not above 0");
  expectSpoiledSlice(1, "1\\0.5", "1\\nan", "PixelSpacing is");
  expectSpoiledSlice(1, std::string("\x28\0\x10\0US\2\0\2", 9), std::string("\x28\0\x10\0US\2\0\3", 9), "another size");
  expectSpoiledSlice(1, "-150", "1e39", "not a finite");
  expectSpoiledSlice(1, std::string("1.2.3.4\0", 8), std::string("1.2.3.5\0", 8), "another series");
  expectSpoiledSlice(1, "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.5", "nor of run lengths");
  expectSpoiledSlice(1, "MONOCHROME2 ", "RGB         ", "");
  expectSpoiledSlice(1, std::string("\x20\0\x32\0", 4), std::string("\x20\0\x31\0", 4), "no ImagePositionPatient");
}

TEST_F(BadFormats, MissingSlicesAndCutOnesAreNoticed) {
  std::filesystem::create_directory(folder.path("series"));
  const auto copy = [&](int name, std::size_t cut) {
    const std::string file = "series/" + std::to_string(name) + ".dcm";
    const std::string bytes = readBytes(dataFile(file));
    folder.write(file, bytes.substr(0, bytes.size() - cut));
  };
  for (const int name : {9, 8, 6}) copy(name, 0);
  folder.write("series/notes.txt", "not a slice");
  expectError([&] { io::readVolume(folder.path("series")); }, "evenly spaced, none missing");
  copy(7, 0);
  EXPECT_NO_THROW(io::readVolume(folder.path("series")));
  for (std::size_t cut = 1; cut < 500; ++cut) {
    copy(7, cut);
    EXPECT_THROW(io::readVolume(folder.path("series")), Error) << cut << " bytes cut off";
  }
}

TEST_F(BadFormats, ReadersOfDicomPrintNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  expectSpoiledSlice(1, "DICM", "DUMM", "");
  expectSpoiledSlice(1, std::string("\xe0\x7f\x10\0OW", 6), std::string("\xe0\x7f\x10\0ZZ", 6), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
