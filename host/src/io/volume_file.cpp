// SPDX-License-Identifier: Apache-2.0
// Which reader a volume file gets, by its ending.
#include "io/volume_file.hpp"

#include <filesystem>

#include <cdsm/error.hpp>

#include "io/dicom_series.hpp"
#include "io/input_file.hpp"
#include "io/metaimage_file.hpp"
#include "io/nifti_file.hpp"
#include "io/nrrd_file.hpp"
#include "io/raw_file.hpp"
#include "io/vdb_file.hpp"
#include "io/vti_file.hpp"

namespace cdsm::io {

namespace {

using Reader = StoredVolume (*)(const std::string&, const VolumePart&);

struct Format {
  const char* ending;
  Reader read;
};

/// A reader of files that hold one volume.
template <StoredVolume (*read)(const std::string&)>
StoredVolume readOnly(const std::string& path, const VolumePart&) {
  return read(path);
}

StoredVolume readVdbPart(const std::string& path, const VolumePart& part) { return readVdb(path, part.grid); }
StoredVolume readVtiPart(const std::string& path, const VolumePart& part) { return readVti(path, part.array); }

constexpr Format kFormats[] = {{".nrrd", readOnly<readNrrd>},
                               {".nhdr", readOnly<readNrrd>},
                               {".mhd", readOnly<readMetaImage>},
                               {".mha", readOnly<readMetaImage>},
                               {".nii", readOnly<readNifti>},
                               {".nii.gz", readOnly<readNifti>},
                               {".hdr", readOnly<readNifti>},
                               {".img", readOnly<readNifti>},
                               {".vdb", readVdbPart},
                               {".vti", readVtiPart},
                               {".raw", readOnly<readRaw>},
                               {".raw.gz", readOnly<readRaw>}};

bool isFolder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

Reader readerFor(const std::string& path) {
  if (isFolder(path)) return readOnly<readDicomSeries>;
  for (const Format& format : kFormats)
    if (hasEnding(path, format.ending)) return format.read;
  if (hasEnding(path, ".dcm"))
    throw Error(Location{path}, "is one slice of a DICOM series; name the folder that holds all of them");
  throw Error(Location{path},
              "is not known as a volume by its ending; volumes are read from .nrrd, .nhdr, .mhd, .mha, .nii, .nii.gz, "
              ".hdr, .img, .vdb, .vti, .raw and .raw.gz, and from folders of DICOM slices");
}

void refuseOtherParts(const VolumePart& part, Reader reader) {
  if (!part.grid.empty() && reader != readVdbPart)
    throw Error("grid chooses one of the grids of an OpenVDB file (.vdb), must be left out for others");
  if (!part.array.empty() && reader != readVtiPart)
    throw Error("array chooses one of the arrays of a VTK file (.vti), must be left out for others");
}

}  // namespace

std::shared_ptr<const VolumeData> readVolume(const std::string& path, const VolumePart& part) {
  const Reader read = readerFor(path);
  refuseOtherParts(part, read);
  // one message for missing, empty and odd files, whatever the format
  if (!isFolder(path)) inputFileSize(path);
  return makeVolume(path, read(path, part));
}

}  // namespace cdsm::io
