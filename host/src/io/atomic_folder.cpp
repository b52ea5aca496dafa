// SPDX-License-Identifier: Apache-2.0
// Temporary folder and renames; see atomic_folder.hpp.
#include "io/atomic_folder.hpp"

#include <unistd.h>

#include <system_error>
#include <utility>

#include <cdsm/error.hpp>

namespace cdsm::io {
namespace {

namespace fs = std::filesystem;

/// The folder itself where the path is a link or ends in a slash.
fs::path finalTarget(const std::string& path) {
  if (path.empty()) throw Error("the path of the result is empty; name a folder");
  std::error_code failed;
  fs::path target = fs::weakly_canonical(fs::absolute(path), failed);
  if (failed) target = fs::absolute(path);
  if (!target.has_filename()) target = target.parent_path();
  return target;
}

fs::path hiddenBeside(const fs::path& target, const std::string& ending) {
  const std::string name = "." + target.filename().string().substr(0, 200);
  return target.parent_path() / (name + "." + std::to_string(getpid()) + ending);
}

}  // namespace

AtomicFolder::AtomicFolder(const std::string& path, std::set<std::string> own)
    : path_(path), own_(std::move(own)), target_(finalTarget(path)) {
  requireReplaceable();
  std::error_code failed;
  if (!fs::is_directory(target_.parent_path(), failed))
    throw Error(Location{path}, "its folder " + target_.parent_path().string() + " does not exist; make it first");
  const fs::path temporary = hiddenBeside(target_, ".part");
  if (!fs::create_directory(temporary, failed))
    throw Error(Location{path}, "cannot be written: " + (failed ? failed.message() : temporary.string() + " is there"));
  temporary_ = temporary;
}

AtomicFolder::~AtomicFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void AtomicFolder::requireReplaceable() const {
  std::error_code failed;
  const fs::file_status status = fs::status(target_, failed);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw Error(Location{path_}, "is a file; name a folder for the result");
  for (const fs::directory_entry& entry : fs::directory_iterator(target_, failed))
    if (!own_.count(entry.path().filename().string()) || !entry.is_regular_file(failed))
      throw Error(Location{path_}, "holds " + entry.path().filename().string() +
                                       ", which is no part of a result; name a new folder or an earlier result");
  if (failed) throw Error(Location{path_}, "cannot be read: " + failed.message());
}

std::string AtomicFolder::file(const std::string& name) const { return (temporary_ / name).string(); }

void AtomicFolder::commit() {
  requireReplaceable();
  std::error_code failed;
  const fs::path earlier = hiddenBeside(target_, ".old");
  const bool replaces = fs::exists(target_, failed);
  if (replaces) fs::rename(target_, earlier, failed);
  if (!failed) fs::rename(temporary_, target_, failed);
  if (failed) {
    std::error_code ignored;
    if (replaces) fs::rename(earlier, target_, ignored);
    throw Error(Location{path_}, "cannot be written: " + failed.message());
  }
  temporary_.clear();
  fs::remove_all(earlier, failed);
}

}  // namespace cdsm::io
