// SPDX-License-Identifier: Apache-2.0
// In: the path of a result that is a folder. Out: either the whole new folder there, or what was there before.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace cdsm::io {

/// A temporary folder beside the result, moved into place by commit() and removed if that never happens.
class AtomicFolder {
 public:
  /// Makes the temporary folder. A folder that is there already is replaced if it holds files of the names in `own`
  /// alone, an earlier result. Throws Error if it holds others, is no folder, or if the folder around it is missing or
  /// not writable.
  AtomicFolder(const std::string& path, std::set<std::string> own);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Where to write the file of that name, which must be one of `own`.
  std::string file(const std::string& name) const;
  /// Puts the temporary folder in the place of the result. Throws Error if that fails.
  void commit();

 private:
  void requireReplaceable() const;

  std::string path_;
  std::set<std::string> own_;
  std::filesystem::path target_, temporary_;
};

}  // namespace cdsm::io
