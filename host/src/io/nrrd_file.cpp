// SPDX-License-Identifier: Apache-2.0
// NRRD through teem's header parser; see nrrd_file.hpp.
#include "io/nrrd_file.hpp"

#include <cmath>
#include <cstdlib>
#include <mutex>

#include <teem/nrrd.h>

#include <cdsm/error.hpp>

#include "io/ascii_voxels.hpp"
#include "io/input_file.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

/// A header longer than this is none.
constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 20;

struct NrrdDelete {
  void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
  void operator()(NrrdIoState* state) const { nrrdIoStateNix(state); }
};

struct Header {
  std::unique_ptr<Nrrd, NrrdDelete> nrrd{nrrdNew()};
  std::unique_ptr<NrrdIoState, NrrdDelete> io{nrrdIoStateNew()};
};

/// teem's messages in one line; they come with a line per function called.
std::string biffMessage() {
  char* text = biffGetDone(NRRD);
  std::string message;
  for (std::string_view rest = text ? text : ""; !rest.empty();) {
    const std::string_view line = trimmed(takeLine(rest));
    if (!line.empty()) message = line;  // the last one is the cause
  }
  std::free(text);
  return printable(message.substr(message.find("] ") == std::string::npos ? 0 : message.find("] ") + 2));
}

Header loadHeader(const std::string& path) {
  static std::mutex teemIsNotThreadSafe;
  const std::lock_guard<std::mutex> lock(teemIsNotThreadSafe);
  Header header;
  nrrdIoStateSet(header.io.get(), nrrdIoStateSkipData, 1);
  if (nrrdLoad(header.nrrd.get(), path.c_str(), header.io.get()) != 0)
    throw Error(Location{path}, "is not a NRRD file that teem can read: " + biffMessage());
  return header;
}

StoredType storedType(const std::string& path, const Nrrd& nrrd) {
  switch (nrrd.type) {
    case nrrdTypeChar:
      return StoredType::Int8;
    case nrrdTypeUChar:
      return StoredType::UInt8;
    case nrrdTypeShort:
      return StoredType::Int16;
    case nrrdTypeUShort:
      return StoredType::UInt16;
    case nrrdTypeInt:
      return StoredType::Int32;
    case nrrdTypeUInt:
      return StoredType::UInt32;
    case nrrdTypeLLong:
      return StoredType::Int64;
    case nrrdTypeULLong:
      return StoredType::UInt64;
    case nrrdTypeFloat:
      return StoredType::Float32;
    case nrrdTypeDouble:
      return StoredType::Float64;
    default:
      throw Error(Location{path}, "has voxels of type block; a number type is needed");
  }
}

bool hasDirection(const Nrrd& nrrd, unsigned axis) {
  return nrrd.spaceDim > 0 && std::isfinite(nrrd.axis[axis].spaceDirection[0]);
}

/// The three axes of the grid, fastest first: all but those of size 1 that have no direction.
std::vector<unsigned> gridAxes(const std::string& path, const Nrrd& nrrd) {
  std::vector<unsigned> axes;
  unsigned tooMany = nrrd.dim > 3 ? nrrd.dim - 3 : 0;
  for (unsigned axis = 0; axis < nrrd.dim; ++axis) {
    const bool drop = tooMany > 0 && nrrd.axis[axis].size == 1 && !hasDirection(nrrd, axis);
    if (drop)
      --tooMany;
    else
      axes.push_back(axis);
  }
  if (axes.size() != 3)
    throw Error(Location{path},
                "has " + std::to_string(nrrd.dim) +
                    " dimensions; a volume is one scalar grid of three (no colours, vectors or time steps)");
  return axes;
}

glm::dvec3 axisStep(const std::string& path, const Nrrd& nrrd, unsigned axis, int column, bool directions) {
  glm::dvec3 step(0.0);
  if (!directions) {
    const double spacing = nrrd.axis[axis].spacing;
    step[column] = std::isnan(spacing) ? 1.0 : spacing;
    return step;
  }
  if (!hasDirection(nrrd, axis))
    throw Error(Location{path}, "one of its three axes has no space direction; a volume is a scalar grid in space");
  const double* direction = nrrd.axis[axis].spaceDirection;
  return glm::dvec3(direction[0], direction[1], direction[2]);
}

glm::dmat4 objectFromIndex(const std::string& path, const Nrrd& nrrd, const std::vector<unsigned>& axes) {
  if (nrrd.spaceDim != 0 && nrrd.spaceDim != 3)
    throw Error(Location{path}, "lies in a space of " + std::to_string(nrrd.spaceDim) + " dimensions; 3 are needed");
  bool directions = false;
  for (const unsigned axis : axes) directions = directions || hasDirection(nrrd, axis);
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 3; ++column)
    matrix[column] = glm::dvec4(axisStep(path, nrrd, axes[column], column, directions), 0.0);
  const double* origin = nrrd.spaceOrigin;
  if (nrrd.spaceDim == 3 && std::isfinite(origin[0])) matrix[3] = glm::dvec4(origin[0], origin[1], origin[2], 1.0);
  return matrix;
}

/// Bytes up to and with the header's empty last line.
std::uint64_t headerBytes(const std::string& path) {
  const std::string text = readText(path, kMaxHeaderBytes);
  std::string_view rest = text;
  while (!rest.empty())
    if (takeLine(rest).empty()) return text.size() - rest.size();
  throw Error(Location{path}, "its header does not end; an empty line must stand between header and data");
}

/// Moves the block's start behind the lines that "line skip" names.
void skipLines(DataBlock& block, unsigned lines) {
  if (lines == 0) return;
  const std::string text = readText(block.path);
  std::size_t at = block.offset;
  for (; lines > 0 && at < text.size(); --lines) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  block.offset = at;
}

DataBlock dataBlock(const std::string& path, const NrrdIoState& io) {
  DataBlock block;
  const unsigned files = io.dataFNArr ? io.dataFNArr->len : 0;
  if (io.dataFNFormat || files > 1)
    throw Error(Location{path}, "keeps its data in several files; join them (unu save -f nrrd -i FILE -o OUT)");
  block.path = files == 0 ? path : besideHeader(path, io.dataFN[0]);
  block.offset = files == 0 ? headerBytes(path) : 0;
  block.encoding = io.encoding == nrrdEncodingGzip ? DataBlock::Encoding::Deflated : DataBlock::Encoding::Raw;
  skipLines(block, io.lineSkip);
  return block;
}

std::vector<std::byte> readData(const std::string& path, const NrrdIoState& io, const StoredVolume& stored) {
  const std::uint64_t bytes = checkedBytes(path, stored.size, stored.type);
  DataBlock block = dataBlock(path, io);
  if (io.byteSkip >= 0) {
    block.skip = static_cast<std::uint64_t>(io.byteSkip);
  } else {  // "byte skip: -1": the data are the file's last bytes
    const std::uint64_t size = inputFileSize(block.path);
    if (size > block.offset + bytes) block.offset = size - bytes;
  }
  if (io.encoding == nrrdEncodingRaw || io.encoding == nrrdEncodingGzip) return readBlock(block, bytes);
  if (io.encoding == nrrdEncodingAscii) return readAsciiVoxels(block, bytes / storedBytes(stored.type), stored.type);
  throw Error(Location{path}, "has the encoding " + std::string(io.encoding->name) +
                                  "; raw, gzip and ascii are read (unu save -f nrrd -e gzip -i FILE -o OUT)");
}

}  // namespace

StoredVolume readNrrd(const std::string& path) {
  if (readText(path, 4) != "NRRD") throw Error(Location{path}, "is not a NRRD file; it must begin with NRRD000");
  const Header header = loadHeader(path);
  const Nrrd& nrrd = *header.nrrd;
  const std::vector<unsigned> axes = gridAxes(path, nrrd);
  StoredVolume stored;
  stored.type = storedType(path, nrrd);
  for (int i = 0; i < 3; ++i) stored.size[i] = nrrd.axis[axes[i]].size;
  stored.objectFromIndex = objectFromIndex(path, nrrd, axes);
  stored.bytes = readData(path, *header.io, stored);
  const bool hostOrder = header.io->encoding == nrrdEncodingAscii;
  stored.bigEndian = (hostOrder ? airMyEndian() : header.io->endian) == airEndianBig;
  return stored;
}

}  // namespace cdsm::io
