// SPDX-License-Identifier: Apache-2.0
// For programs that use OpenCL themselves: an engine in their context, data and results in their buffers, shadows in
// their kernels. Include it after the OpenCL version that you want is said (CL_TARGET_OPENCL_VERSION).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <CL/cl.h>
#include <cdsm/cdsm.hpp>

/// Buffers that are passed in must be of the engine's context, or DeviceError is thrown. What is enqueued goes to the
/// engine's queue.
namespace cdsm::opencl {

/// Where an engine works.
struct Place {
  cl_context context = nullptr;
  cl_device_id device = nullptr;     ///< one of the context's
  cl_command_queue queue = nullptr;  ///< in order, of that context and device; null: the engine makes its own
};

/// An engine in a context that is there already; it retains all three as long as it lives. A queue without profiling is
/// fine: times of the device are then 0, and stats().deviceTimes says so. EngineOptions::device must be empty. Throws
/// Error if the three do not belong together, or the device cannot be used.
CDSM_API Engine makeEngine(const Place& place, const EngineOptions& options = {});

/// Where the engine works; not retained for the caller.
CDSM_API Place placeOf(const Engine& engine);

/// Voxels side by side, x fastest, in a buffer that is retained as long as the result lives. The engine reads it where
/// it is, or copies it to an image once. What VoxelView says about writing to it holds here, too. Sizes are checked by
/// the engine that gets it.
CDSM_API std::shared_ptr<VolumeData> volumeData(cl_mem buffer, VoxelType type, const glm::uvec3& size,
                                                const glm::mat4& objectFromIndex = glm::mat4(1.0f));

/// Voxels of a 3D image of one channel (CL_R, CL_LUMINANCE, CL_INTENSITY), whose integers or floats are the values,
/// also of a normalized format. Devices that read volumes from images read it where it is if it is CL_R and
/// CL_UNORM_INT8, CL_UNORM_INT16 or CL_FLOAT, once they have looked at a copy; else they use a copy, one for each
/// Volume::revision. It is retained as a buffer is. Throws Error for images of other kinds.
CDSM_API std::shared_ptr<VolumeData> volumeData(cl_mem image, const glm::mat4& objectFromIndex = glm::mat4(1.0f));

/// Points in a buffer, x y z each.
struct Points {
  cl_mem buffer = nullptr;
  std::size_t count = 0;
  std::size_t stride = 3;  ///< floats from a point to the next, at least 3; 4: float4
};

/// What a command waits for, and how its end is told.
struct Order {
  std::vector<cl_event> after;  ///< of any queue of the context
  cl_event* done = nullptr;     ///< gets an event that the caller releases; null: the call waits for the end
};

/// As Engine::transmittance() for the scene that was given last: `count` times Engine::channels() floats into `values`,
/// -1 where not lit, as for points that are not finite. With Order::done the work may still run when the call returns:
/// both buffers must stay, and stats() knows no times of it.
CDSM_API void transmittance(Engine& engine, const std::string& light, const Points& points, cl_mem values,
                            const Order& order = {});

/// The camera's image into a buffer of width * height float4, or a 2D image of that size with four floats a pixel.
CDSM_API void render(Engine& engine, const Scene& scene, cl_mem target);

/// The shadows of a scene as a function for other kernels (docs/embedding.md). Keeps the buffers that it hands out and
/// the VolumeData that they lie in. What is in them is that scene's until the engine is given another one or draws an
/// image: then take a new Lookup.
class CDSM_API Lookup {
 public:
  ~Lookup();
  Lookup(Lookup&&) noexcept;
  Lookup& operator=(Lookup&&) noexcept;

  /// OpenCL C that comes in front of the text of the kernels. It changes with the technique, the memory strategy, the
  /// format of nodes, the colours of transmittance, the cache, the types of the volumes and whether there are spheres,
  /// with nothing else: a program that was made with it can be used as long as it is the same.
  const std::string& source() const;
  /// To compile it with: else results may differ in the last bits.
  const std::string& buildOptions() const;

  /// Number of a light for cdsmTransmittance(). Throws Error for an unknown one.
  unsigned light(const std::string& name) const;

  /// Sets CDSM_LOOKUP_PARAMS, which begin at argument number `first`. Returns the number of the argument behind them.
  cl_uint setArguments(cl_kernel kernel, cl_uint first) const;

 private:
  struct Impl;
  friend CDSM_API Lookup lookup(Engine& engine);
  explicit Lookup(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

/// Of the scene that the engine was given last.
CDSM_API Lookup lookup(Engine& engine);

}  // namespace cdsm::opencl
