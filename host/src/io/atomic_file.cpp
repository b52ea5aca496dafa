// SPDX-License-Identifier: Apache-2.0
// Temporary file and rename; see atomic_file.hpp.
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <cdsm/error.hpp>

namespace cdsm::io {

namespace fs = std::filesystem;

namespace {

fs::path finalTarget(const std::string& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (path.empty()) throw Error("the path of the result is empty; name a file");
  if (fs::is_directory(status)) throw Error(Location{path}, "is a folder; name a file to write");
  if (!fs::exists(status)) return path;
  if (!fs::is_regular_file(status)) throw Error(Location{path}, "is not a regular file and will not be replaced");
  const fs::path target = fs::canonical(path, code);
  return code ? fs::path(path) : target;
}

/// Names differ between processes and within one; O_EXCL catches what is left over from others.
std::string createBeside(const std::string& path, const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code code;
  if (!fs::is_directory(folder, code))
    throw Error(Location{path}, "its folder " + folder.string() + " does not exist; make it first");
  for (int attempt = 0; attempt < 100; ++attempt) {
    const fs::path name = "." + target.filename().string().substr(0, 200) + "." + std::to_string(getpid()) + "-" +
                          std::to_string(counter++) + ".part";
    const std::string candidate = (folder / name).string();
    const int file = open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    const int failure = errno;
    if (file >= 0) {
      close(file);
      return candidate;
    }
    if (failure != EEXIST)
      throw Error(Location{path}, "cannot be written: " + std::generic_category().message(failure));
  }
  throw Error(Location{path}, "cannot be written: too many .part files are left in its folder; remove them");
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  const fs::path target = finalTarget(path);
  target_ = target.string();
  temporary_ = createBeside(path, target);
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  std::error_code code;
  fs::rename(temporary_, target_, code);
  if (code) throw Error(Location{path_}, "cannot be written: " + code.message());
  temporary_.clear();
}

void checkOutputPath(const std::string& path) { const AtomicFile probe(path); }

}  // namespace cdsm::io
