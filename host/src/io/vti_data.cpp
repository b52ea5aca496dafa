// SPDX-License-Identifier: Apache-2.0
// Base64 and zlib blocks of VTK's XML files; see vti_data.hpp.
#include "io/vti_data.hpp"

#include <array>
#include <cstring>

#include <zlib.h>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"

namespace cdsm::io {

namespace {

/// The value of a base64 digit, or -1.
int digitOf(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

bool isBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Hands out the bytes of an array one piece after another.
class ByteSource {
 public:
  ByteSource(const std::string& path, const VtiData& data) : path_(path), data_(data), rest_(data.text) {}

  /// The next `count` bytes; they stay valid until the next call.
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size() + decoded_.size()) throwTooShort();
    if (data_.base64) return takeDecoded(static_cast<std::size_t>(count));
    const std::string_view piece = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(piece.size());
    return piece;
  }

  std::uint64_t takeInteger() {
    const std::string_view bytes = take(data_.countBytes);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::size_t at = data_.bigEndian ? i : bytes.size() - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return value;
  }

 private:
  [[noreturn]] void throwTooShort() const {
    throw Error(Location{path_}, "holds fewer bytes of voxels than its header asks for; is the file cut short?");
  }

  /// Padding may stand in the middle: some writers encode the header of the data by itself.
  std::string_view takeDecoded(std::size_t count) {
    decoded_.erase(0, taken_);
    while (decoded_.size() < count) decodeFour();
    taken_ = count;
    return std::string_view(decoded_).substr(0, count);
  }

  void decodeFour() {
    std::uint32_t bits = 0;
    int digits = 0;
    int padding = 0;
    while (digits + padding < 4) {
      if (rest_.empty() || rest_.front() == '<') throwTooShort();
      const char c = rest_.front();
      rest_.remove_prefix(1);
      if (isBlank(c)) continue;
      if ((c == '=' ? digits < 2 : padding > 0 || digitOf(c) < 0))
        throw Error(Location{path_}, "has data with a character that cannot stand there in base64");
      bits = bits << 6 | static_cast<std::uint32_t>(c == '=' ? 0 : digitOf(c));
      ++(c == '=' ? padding : digits);
    }
    for (int i = 0; i < 3 - padding; ++i) decoded_.push_back(static_cast<char>(bits >> (16 - 8 * i)));
  }

  std::string path_;
  const VtiData& data_;
  std::string_view rest_;
  std::string decoded_;  ///< base64: what is decoded; its first `taken_` bytes are handed out
  std::size_t taken_ = 0;
};

[[noreturn]] void throwWrongSize(const std::string& path, std::uint64_t held, std::uint64_t bytes) {
  throw Error(Location{path}, "has an array of " + std::to_string(held) + " bytes, but its extent and type need " +
                                  std::to_string(bytes) + "; sizes and type must match the data");
}

std::vector<std::byte> readPlain(const std::string& path, ByteSource& source, std::uint64_t bytes) {
  if (const std::uint64_t held = source.takeInteger(); held != bytes) throwWrongSize(path, held, bytes);
  const std::string_view piece = source.take(bytes);
  std::vector<std::byte> data(piece.size());
  std::memcpy(data.data(), piece.data(), piece.size());
  return data;
}

/// Blocks of equal size but for the last one; sizes after and before packing.
struct Blocks {
  std::uint64_t size = 0, last = 0;
  std::vector<std::uint64_t> packed;

  std::uint64_t sizeOf(std::size_t i) const { return i + 1 == packed.size() && last != 0 ? last : size; }
};

Blocks readBlocks(const std::string& path, ByteSource& source, std::uint64_t bytes, std::uint64_t held) {
  const std::uint64_t count = source.takeInteger();
  Blocks blocks;
  blocks.size = source.takeInteger();
  blocks.last = source.takeInteger();
  if (count == 0 || count > held || blocks.size > bytes || blocks.last > blocks.size)
    throw Error(Location{path}, "has compressed data whose blocks make no sense; is the file damaged?");
  const std::uint64_t whole = blocks.last == 0 ? count : count - 1;
  if (whole > bytes / std::max<std::uint64_t>(blocks.size, 1) || whole * blocks.size + blocks.last != bytes)
    throw Error(Location{path}, "has compressed data of another size than the " + std::to_string(bytes) +
                                    " bytes that its extent and type need");
  for (std::uint64_t i = 0; i < count; ++i) blocks.packed.push_back(source.takeInteger());
  return blocks;
}

std::vector<std::byte> readCompressed(const std::string& path, ByteSource& source, std::uint64_t bytes,
                                      std::uint64_t held) {
  if (bytes / kMaxDeflateRatio > held)
    throw Error(Location{path}, "holds fewer bytes of voxels than its header asks for; is the file cut short?");
  const Blocks blocks = readBlocks(path, source, bytes, held);
  std::vector<std::byte> data(bytes);
  std::byte* out = data.data();
  for (std::size_t i = 0; i < blocks.packed.size(); ++i) {
    const std::string_view packed = source.take(blocks.packed[i]);
    uLongf size = blocks.sizeOf(i);
    const int code =
        uncompress(reinterpret_cast<Bytef*>(out), &size, reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (code != Z_OK || size != blocks.sizeOf(i))
      throw Error(Location{path},
                  "the compressed data are damaged in block " + std::to_string(i) + "; get or write the file again");
    out += size;
  }
  return data;
}

}  // namespace

std::vector<std::byte> readVtiData(const std::string& path, const VtiData& data, std::uint64_t bytes) {
  ByteSource source(path, data);
  return data.compressed ? readCompressed(path, source, bytes, data.text.size()) : readPlain(path, source, bytes);
}

}  // namespace cdsm::io
