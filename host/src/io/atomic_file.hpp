// SPDX-License-Identifier: Apache-2.0
// In: the path of a result. Out: either the whole new file under that path, or whatever was there before.
#pragma once

#include <string>

namespace cdsm::io {

/// A temporary file beside the result, moved into place by commit() and removed if that never happens.
class AtomicFile {
 public:
  /// Creates the temporary file. Throws Error if the folder is missing or not writable, or if the path is there
  /// already and is not a regular file. A link is followed: what it points to is replaced.
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write; close it before commit().
  const std::string& temporaryPath() const { return temporary_; }
  /// Puts the temporary file in the place of the result. Throws Error if that fails.
  void commit();

 private:
  std::string path_;
  std::string target_;
  std::string temporary_;
};

/// Throws what writing to that path would throw, as far as that can be known before; leaves nothing behind.
void checkOutputPath(const std::string& path);

}  // namespace cdsm::io
