// SPDX-License-Identifier: Apache-2.0
// Reading of raw and deflated blocks; see input_file.hpp.
#include "io/input_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <new>

#include <zlib.h>

#include <cdsm/error.hpp>

namespace cdsm::io {

namespace {

/// Bytes read or unpacked at a time: memory grows with what is really there.
constexpr std::size_t kPiece = std::size_t{1} << 20;

std::ifstream openInput(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(Location{path}, "cannot be opened for reading; check the file's permissions");
  return stream;
}

[[noreturn]] void throwTooShort(const DataBlock& block, std::uint64_t bytes) {
  throw Error(Location{block.path}, "holds fewer than the " + std::to_string(bytes) +
                                        " bytes of voxels that its header asks for; is the file cut short?");
}

[[noreturn]] void throwTooLong(const DataBlock& block, std::uint64_t bytes) {
  throw Error(Location{block.path},
              "holds more than the " + std::to_string(bytes) +
                  " bytes of voxels that its header asks for; sizes and type must match the data");
}

std::vector<std::byte> readRaw(const DataBlock& block, std::uint64_t bytes, std::uint64_t held) {
  if (held < block.skip || held - block.skip < bytes) throwTooShort(block, bytes);
  if (held - block.skip > bytes) throwTooLong(block, bytes);
  std::ifstream stream = openInput(block.path);
  stream.seekg(static_cast<std::streamoff>(block.offset + block.skip));
  std::vector<std::byte> data(bytes);
  stream.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uint64_t>(stream.gcount()) != bytes) throwTooShort(block, bytes);
  return data;
}

/// Unpacks one deflated block piece by piece, gzip members one after another.
class Inflater {
 public:
  explicit Inflater(const DataBlock& block) : path_(block.path), stream_(openInput(block.path)), input_(kPiece) {
    stream_.seekg(static_cast<std::streamoff>(block.offset));
    constexpr int kGzipOrZlib = 15 + 32;  // the largest window; + 32: detect the header
    if (inflateInit2(&z_, kGzipOrZlib) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&z_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Unpacks up to `most` bytes; fewer only at the end of the block. Checksums are checked when their end is reached.
  std::size_t read(std::byte* out, std::size_t most) {
    z_.next_out = reinterpret_cast<Bytef*>(out);
    z_.avail_out = static_cast<uInt>(most);
    while (z_.avail_out > 0 && haveInput()) step();
    return most - z_.avail_out;
  }

  /// Whether all that was begun is unpacked, checksum included.
  bool complete() const { return memberDone_; }

 private:
  bool haveInput() {
    if (z_.avail_in > 0) return true;
    stream_.read(reinterpret_cast<char*>(input_.data()), static_cast<std::streamsize>(input_.size()));
    z_.next_in = input_.data();
    z_.avail_in = static_cast<uInt>(stream_.gcount());
    return z_.avail_in > 0;
  }

  void step() {
    if (memberDone_) inflateReset(&z_);
    memberDone_ = false;
    const int code = inflate(&z_, Z_NO_FLUSH);
    memberDone_ = code == Z_STREAM_END;
    if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR)
      throw Error(Location{path_}, "the compressed data are damaged (" + std::string(z_.msg ? z_.msg : "zlib error") +
                                       "); get or write the file again");
  }

  std::string path_;
  std::ifstream stream_;
  std::vector<Bytef> input_;
  z_stream z_{};
  bool memberDone_ = false;
};

void skipBytes(Inflater& inflater, std::uint64_t count, const DataBlock& block, std::uint64_t bytes) {
  std::vector<std::byte> ignored(kPiece);
  while (count > 0) {
    const std::size_t read = inflater.read(ignored.data(), std::min<std::uint64_t>(count, kPiece));
    if (read == 0) throwTooShort(block, bytes);
    count -= read;
  }
}

std::vector<std::byte> readDeflated(const DataBlock& block, std::uint64_t bytes, std::uint64_t held) {
  if (bytes / kMaxDeflateRatio > held) throwTooShort(block, bytes);
  Inflater inflater(block);
  skipBytes(inflater, block.skip, block, bytes);
  std::vector<std::byte> data;
  while (data.size() < bytes) {
    const std::size_t before = data.size();
    const std::size_t piece = std::min<std::uint64_t>(bytes - before, std::max(before, kPiece));
    data.resize(before + std::min<std::size_t>(piece, UINT32_MAX));
    const std::size_t read = inflater.read(data.data() + before, data.size() - before);
    if (read < data.size() - before) throwTooShort(block, bytes);
  }
  std::byte beyond;
  if (inflater.read(&beyond, 1) > 0) throwTooLong(block, bytes);  // reading on also checks the checksum
  if (!inflater.complete()) throwTooShort(block, bytes);
  return data;
}

}  // namespace

bool hasEnding(const std::string& path, const std::string& ending) {
  if (path.size() < ending.size()) return false;
  return std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

std::uint64_t inputFileSize(const std::string& path) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) throw Error(Location{path}, "there is no such file; check the path");
  if (std::filesystem::is_directory(status)) throw Error(Location{path}, "is a folder; a file is needed");
  if (!std::filesystem::is_regular_file(status)) throw Error(Location{path}, "is not a regular file");
  const std::uint64_t size = std::filesystem::file_size(path, code);
  if (code) throw Error(Location{path}, "cannot be read: " + code.message());
  if (size == 0) throw Error(Location{path}, "is empty");
  return size;
}

std::string readText(const std::string& path, std::uint64_t most) {
  std::string text(std::min(inputFileSize(path), most), '\0');
  std::ifstream stream = openInput(path);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

std::string readUnpackedText(const std::string& path) {
  if (!hasEnding(path, ".gz")) return readText(path);
  inputFileSize(path);
  Inflater inflater(DataBlock{path, DataBlock::Encoding::Deflated, 0, 0});
  std::string text;
  for (std::size_t read = kPiece; read == kPiece;) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    read = inflater.read(reinterpret_cast<std::byte*>(text.data()) + before, kPiece);
    text.resize(before + read);
  }
  if (!inflater.complete()) throw Error(Location{path}, "the compressed data end too early; is the file cut short?");
  return text;
}

std::string besideHeader(const std::string& header, const std::string& name) {
  return (std::filesystem::path(header).parent_path() / name).string();
}

std::vector<std::byte> readStart(const DataBlock& block, std::size_t most) {
  inputFileSize(block.path);
  std::vector<std::byte> data(most);
  if (block.encoding == DataBlock::Encoding::Deflated) {
    Inflater inflater(block);
    skipBytes(inflater, block.skip, block, most);
    data.resize(inflater.read(data.data(), most));
  } else {
    std::ifstream stream = openInput(block.path);
    stream.seekg(static_cast<std::streamoff>(block.offset + block.skip));
    stream.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(most));
    data.resize(static_cast<std::size_t>(stream.gcount()));
  }
  return data;
}

std::vector<std::byte> readBlock(const DataBlock& block, std::uint64_t bytes) {
  const std::uint64_t size = inputFileSize(block.path);
  if (size <= block.offset) throwTooShort(block, bytes);
  const std::uint64_t held = size - block.offset;
  try {
    return block.encoding == DataBlock::Encoding::Raw ? readRaw(block, bytes, held) : readDeflated(block, bytes, held);
  } catch (const std::bad_alloc&) {
    throw Error(Location{block.path}, "there is no memory for its " + std::to_string(bytes) + " bytes of voxels");
  }
}

}  // namespace cdsm::io
