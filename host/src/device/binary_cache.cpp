// SPDX-License-Identifier: Apache-2.0
// One file per binary below $CDSM_CACHE_DIR, else $XDG_CACHE_HOME/cdsm, else ~/.cache/cdsm:
// magic | key bytes, binary bytes, hash of the binary (8 bytes each, this machine's order) | key | binary.
#include "device/binary_cache.hpp"

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

namespace cdsm::device {
namespace {

namespace fs = std::filesystem;

struct Header {
  char magic[8];
  std::uint64_t keyBytes;
  std::uint64_t binaryBytes;
  std::uint64_t binaryHash;
};
static_assert(sizeof(Header) == 32);

constexpr char kMagic[8] = {'c', 'd', 's', 'm', 'b', 'i', 'n', '1'};

/// FNV-1a, 64 bits: finds damage and spreads names; not meant against attackers.
std::uint64_t hash(const std::string& bytes) {
  std::uint64_t value = 14695981039346656037ull;
  for (const unsigned char byte : bytes) value = (value ^ byte) * 1099511628211ull;
  return value;
}

std::string hex(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(value));
  return text;
}

/// Empty when the environment names no place.
fs::path cacheFolder() {
  const auto environment = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const fs::path own = environment("CDSM_CACHE_DIR"); !own.empty()) return own;
  if (const fs::path xdg = environment("XDG_CACHE_HOME"); !xdg.empty()) return xdg / "cdsm";
  if (const fs::path home = environment("HOME"); !home.empty()) return home / ".cache" / "cdsm";
  return {};
}

fs::path entryPath(const fs::path& folder, const std::string& key) { return folder / (hex(hash(key)) + ".bin"); }

std::string serialized(const std::string& key, const std::string& binary) {
  Header header{{}, key.size(), binary.size(), hash(binary)};
  std::memcpy(header.magic, kMagic, sizeof(kMagic));
  return std::string(reinterpret_cast<const char*>(&header), sizeof(header)) + key + binary;
}

/// The binary in an entry's bytes; empty unless every part of the entry is as it was written for this key.
std::string parsed(const std::string& bytes, const std::string& key) {
  Header header;
  if (bytes.size() < sizeof(header)) return {};
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (std::memcmp(header.magic, kMagic, sizeof(kMagic)) != 0 || header.keyBytes != key.size()) return {};
  const std::size_t start = sizeof(header) + key.size();
  if (bytes.size() < start || bytes.size() - start != header.binaryBytes) return {};
  if (bytes.compare(sizeof(header), key.size(), key) != 0) return {};
  std::string binary = bytes.substr(start);
  return hash(binary) == header.binaryHash ? binary : std::string();
}

bool writeFile(const fs::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return !file.fail();
}

}  // namespace

std::string loadBinary(const std::string& key) {
  const fs::path folder = cacheFolder();
  if (folder.empty()) return {};
  std::ifstream file(entryPath(folder, key), std::ios::binary);
  if (!file) return {};
  return parsed(std::string(std::istreambuf_iterator<char>(file), {}), key);
}

bool canStoreBinaries() {
  const fs::path folder = cacheFolder();
  std::error_code failure;
  if (!folder.empty()) fs::create_directories(folder, failure);
  return fs::is_directory(folder, failure) && access(folder.c_str(), W_OK) == 0;
}

void storeBinary(const std::string& key, const std::string& binary) {
  const fs::path folder = cacheFolder();
  if (folder.empty() || binary.empty()) return;
  std::error_code ignored;
  const fs::path target = entryPath(folder, key);
  std::random_device random;  // two processes may store the same entry at once
  const fs::path temporary = target.string() + "." + hex((std::uint64_t(random()) << 32) | random()) + ".tmp";
  const bool written = writeFile(temporary, serialized(key, binary));
  if (written) fs::rename(temporary, target, ignored);
  if (!written || ignored) fs::remove(temporary, ignored);
}

}  // namespace cdsm::device
