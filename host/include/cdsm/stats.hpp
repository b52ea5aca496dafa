// SPDX-License-Identifier: Apache-2.0
// Where a frame's time and memory went. Times are milliseconds of the device's own events unless said otherwise.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdsm {

struct MapStats {
  int cluster = 0;
  std::vector<std::string> objects;  ///< names of what casts in this map
  bool regenerated = false;
  std::string reason;  ///< of regenerating it: "first", "settings", "tolerance", "light moved", "light turned", "cone",
                       ///< "light", "cluster", "objects", "object NAME", "transfer function of NAME"; empty if kept
  std::uint64_t texels = 0;
  double nodesMean = 0.0;  ///< over all texels, empty ones included
  std::uint64_t nodesMax = 0;
  std::uint64_t nodesTotal = 0;
  double fovX = 0.0, fovY = 0.0;           ///< degrees; 0 for parallel light
  double nearDepth = 0.0, farDepth = 0.0;  ///< world units along the light's axis
};

struct LightStats {
  std::string name;
  std::string type;  ///< spot | omni | directional
  std::vector<MapStats> maps;
};

struct MemoryStats {
  std::string strategy;
  std::uint64_t bytesReserved = 0;  ///< of the finished maps, bookkeeping included
  std::uint64_t bytesUsed = 0;
  std::uint64_t bytesWasted = 0;
  std::uint64_t chunksUsed = 0;    ///< while building, strategy "chunked" alone
  std::uint64_t chunksWasted = 0;  ///< handed out and never written
  double tolerance = 0.0;          ///< that the maps were built at: larger than asked for if they were coarsened
  std::uint64_t limit = 0;         ///< bytes that bytesReserved may not exceed; 0: none
  double bytesPerNode = 0.0;       ///< of a node itself, without bookkeeping
  double mergeError = 0.0;  ///< strategy "fixed" alone: no visibility function moved by more when nodes were merged
};

/// Of shadows.cache "volume".
struct CacheStats {
  std::uint64_t bytes = 0;
  bool filled = false;  ///< in this frame; false: as it was
};

/// Of ambient occlusion.
struct OcclusionStats {
  std::uint64_t bytes = 0;
  int width = 0, height = 0, depth = 0;  ///< cells of its grid along x, y, z
  bool filled = false;                   ///< in this frame; false: as it was
};

/// All launches of a kernel, or transfers, of one human name. Milliseconds are 0 on a queue that keeps no times.
struct KernelTime {
  std::string name;
  double milliseconds = 0.0;
  std::uint64_t launches = 0;
  std::uint64_t bytes = 0;  ///< of transfers and fills
};

/// Of a debug picture.
struct ViewStats {
  std::string name;                    ///< clusters | nodes | layers | steps | texels
  std::optional<std::uint64_t> scale;  ///< the greatest count, if it shows counts
};

struct FrameStats {
  int frame = 0;
  double clusterMs = 0.0, rasterizeMs = 0.0, buildMapsMs = 0.0, renderMs = 0.0;
  double ambientOcclusionMs = 0.0;
  double totalMs = 0.0;  ///< wall clock
  std::vector<LightStats> lights;
  MemoryStats memory;
  std::optional<CacheStats> cache;                 ///< none without one
  std::optional<OcclusionStats> ambientOcclusion;  ///< the same
  std::vector<KernelTime> kernels;
  bool deviceTimes = true;            ///< false: the queue was made without profiling, times of the device are 0
  std::uint64_t uploadedBytes = 0;    ///< from host to device, by the transfers "upload ..." among `kernels`
  std::uint64_t copiedBytes = 0;      ///< of voxels, copied on the host because they did not lie side by side
  std::uint64_t shadedSamples = 0;    ///< volume samples with an opacity, summed over the camera's rays
  std::vector<std::string> warnings;  ///< what is other than the scene asks for, and why
  std::vector<std::string> reports;   ///< what a pass had to repeat, and why ("pair buffer grown to ...")
  std::optional<ViewStats> view;      ///< if the frame was a debug picture
};

}  // namespace cdsm
