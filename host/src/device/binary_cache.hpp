// SPDX-License-Identifier: Apache-2.0
// Program binaries on disk. In: a key (all that the binary depends on, as text) and bytes; out: the same bytes later,
// or nothing. No trouble with the disk is an error.
#pragma once

#include <string>

namespace cdsm::device {

/// The binary kept for `key`; empty if there is none or its entry is damaged. `key` itself is stored and compared, so
/// a collision of file names cannot mix up programs.
std::string loadBinary(const std::string& key);

/// Whether storeBinary() has a folder to write to; makes it if need be. Asked first, since some implementations compile
/// every kernel anew to hand out a binary.
bool canStoreBinaries();

/// Keeps the binary for other runs. Written under a temporary name and renamed, so readers see all of it or none.
void storeBinary(const std::string& key, const std::string& binary);

}  // namespace cdsm::device
