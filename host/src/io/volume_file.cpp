// SPDX-License-Identifier: Apache-2.0
// Which reader a volume file gets, by its ending.
#include "io/volume_file.hpp"

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/metaimage_file.hpp"
#include "io/nifti_file.hpp"
#include "io/nrrd_file.hpp"

namespace cdsm::io {

namespace {

using Reader = StoredVolume (*)(const std::string&);

struct Format {
  const char* ending;
  Reader read;
};

constexpr Format kFormats[] = {{".nrrd", readNrrd},     {".nhdr", readNrrd}, {".mhd", readMetaImage},
                               {".mha", readMetaImage}, {".nii", readNifti}, {".nii.gz", readNifti},
                               {".hdr", readNifti},     {".img", readNifti}};

Reader readerFor(const std::string& path) {
  for (const Format& format : kFormats)
    if (hasEnding(path, format.ending)) return format.read;
  const std::string known = "volumes are read from .nrrd, .nhdr, .mhd, .mha, .nii, .nii.gz, .hdr and .img";
  if (hasEnding(path, ".vdb")) throw Error(Location{path}, "OpenVDB is not supported yet; " + known);
  throw Error(Location{path}, "is not known as a volume by its ending; " + known);
}

}  // namespace

std::shared_ptr<const VolumeData> readVolume(const std::string& path) {
  const Reader read = readerFor(path);
  inputFileSize(path);  // one message for missing, empty and odd files, whatever the format
  return makeVolume(path, read(path));
}

}  // namespace cdsm::io
