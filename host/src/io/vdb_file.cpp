// SPDX-License-Identifier: Apache-2.0
// OpenVDB through its own library; see vdb_file.hpp.
#include "io/vdb_file.hpp"

#include <fstream>
#include <new>

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

/// A few bytes of a sparse file can make a box of any size: a dense grid above this many bytes must not be larger than
/// what deflate could pack into the file.
constexpr std::uint64_t kSmallBytes = std::uint64_t{256} << 20;

/// All grids of the file. Its end is an exception: the library would take what it could not read for zeros.
openvdb::GridPtrVec readGrids(const std::string& path) {
  openvdb::initialize();
  try {
    std::ifstream stream(path, std::ios::binary);
    stream.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    return *openvdb::io::Stream(stream, false).getGrids();
  } catch (const std::ios_base::failure&) {
    throw Error(Location{path}, "ends before its grids do, or cannot be read; is the file cut short?");
  } catch (const std::bad_alloc&) {
    throw Error(Location{path}, "there is no memory for its grids, or their sizes are damaged");
  } catch (const std::exception& error) {
    throw Error(Location{path}, "is not an OpenVDB file that can be read: " + printable(error.what()));
  }
}

std::string describe(const openvdb::GridPtrVec& grids) {
  std::string list;
  for (const auto& grid : grids)
    list += (list.empty() ? "" : ", ") + io::quoted(grid->getName()) + " (" + grid->valueType() + ")";
  return list.empty() ? "none" : list;
}

openvdb::GridBase::Ptr chooseGrid(const std::string& path, const std::string& name) {
  const openvdb::GridPtrVec grids = readGrids(path);
  for (const auto& grid : grids)
    if (name.empty() ? grid->isType<openvdb::FloatGrid>() : grid->getName() == name) return grid;
  const std::string wanted = name.empty() ? "grid of float" : "grid " + io::quoted(name);
  throw Error(Location{path}, "has no " + wanted + "; name one with grid = \"...\", its grids are: " + describe(grids));
}

void checkDenseBytes(const std::string& path, const openvdb::GridBase& grid, const StoredVolume& stored) {
  const std::uint64_t bytes = checkedBytes(path, stored.size, stored.type);
  if (bytes <= kSmallBytes || bytes / kMaxDeflateRatio <= inputFileSize(path)) return;
  const auto& size = stored.size;
  throw Error(Location{path}, "the box of grid " + io::quoted(grid.getName()) + " has " + std::to_string(size[0]) +
                                  " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
                                  " voxels, of which " + std::to_string(grid.activeVoxelCount()) +
                                  " are active; prune or crop stray voxels to make it small enough for a dense grid");
}

/// Of voxel (0, 0, 0) of the dense grid, which is voxel `first` of the sparse one.
glm::dmat4 objectFromIndex(const std::string& path, const openvdb::GridBase& grid, const openvdb::Coord& first) {
  if (!grid.transform().isLinear())
    throw Error(Location{path}, "grid " + io::quoted(grid.getName()) +
                                    " has a frustum as transform; resample it to a grid with parallel axes");
  const openvdb::Mat4R rows = grid.transform().baseMap()->getAffineMap()->getMat4();  // of row vectors
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) matrix[column][row] = rows(column, row);
  matrix[3] = matrix * glm::dvec4(first.x(), first.y(), first.z(), 1.0);
  return matrix;
}

template <typename Grid>
StoredVolume makeDense(const std::string& path, const openvdb::GridBase& base, StoredType type) {
  const Grid& grid = static_cast<const Grid&>(base);
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (box.empty())
    throw Error(Location{path}, "grid " + io::quoted(grid.getName()) + " has no active voxels; there must be some");
  StoredVolume stored;
  stored.type = type;
  stored.bigEndian = hostIsBigEndian();
  for (int axis = 0; axis < 3; ++axis)
    stored.size[axis] = static_cast<std::uint64_t>(std::int64_t{box.max()[axis]} - box.min()[axis] + 1);
  checkDenseBytes(path, grid, stored);
  stored.objectFromIndex = objectFromIndex(path, grid, box.min());
  using Value = typename Grid::ValueType;
  stored.bytes.resize(checkedBytes(path, stored.size, stored.type));
  openvdb::tools::Dense<Value, openvdb::tools::LayoutXYZ> dense(box, reinterpret_cast<Value*>(stored.bytes.data()));
  openvdb::tools::copyToDense(grid, dense);
  return stored;
}

StoredVolume readGrid(const std::string& path, const openvdb::GridBase& grid) {
  if (grid.isType<openvdb::FloatGrid>()) return makeDense<openvdb::FloatGrid>(path, grid, StoredType::Float32);
  if (grid.isType<openvdb::DoubleGrid>()) return makeDense<openvdb::DoubleGrid>(path, grid, StoredType::Float64);
  if (grid.isType<openvdb::Int32Grid>()) return makeDense<openvdb::Int32Grid>(path, grid, StoredType::Int32);
  if (grid.isType<openvdb::Int64Grid>()) return makeDense<openvdb::Int64Grid>(path, grid, StoredType::Int64);
  throw Error(Location{path}, "grid " + io::quoted(grid.getName()) + " is of type " + grid.valueType() +
                                  "; float, double, int32 and int64 are read");
}

}  // namespace

StoredVolume readVdb(const std::string& path, const std::string& grid) {
  const openvdb::GridBase::Ptr chosen = chooseGrid(path, grid);
  try {
    return readGrid(path, *chosen);
  } catch (const std::bad_alloc&) {
    throw Error(Location{path}, "there is no memory for grid " + io::quoted(chosen->getName()) + " as a dense grid");
  }
}

}  // namespace cdsm::io
