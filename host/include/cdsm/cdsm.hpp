// SPDX-License-Identifier: Apache-2.0
// cdsm: clustered deep shadow maps. The whole public interface: a Scene in, images and transmittances out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cdsm/error.hpp>
#include <cdsm/export.hpp>
#include <cdsm/light_map.hpp>
#include <cdsm/scene.hpp>
#include <cdsm/stats.hpp>
#include <cdsm/trace.hpp>

namespace cdsm {

/// What an OpenCL device is and which of the engine's paths it would use.
struct DeviceDescription {
  std::string id;  ///< "platform:device", as `cdsm devices` numbers them
  std::string platform;
  std::string name;
  std::string version;
  std::string type;  ///< cpu | gpu | accelerator | other
  unsigned computeUnits = 0;
  std::uint64_t memoryBytes = 0;
  std::uint64_t maxAllocationBytes = 0;
  std::uint64_t localMemoryBytes = 0;
  bool images = false;
  std::string fetch;     ///< buffer | image: how volumes and maps would be read
  std::string unusable;  ///< empty, or why the engine cannot run on it
};

/// All devices of all platforms; a platform without devices is passed over. Never throws for want of a device.
CDSM_API std::vector<DeviceDescription> listDevices();

struct EngineOptions {
  std::string device;          ///< "platform:device" or part of a name; empty: CDSM_DEVICE, else the first usable
  std::string fetch = "auto";  ///< auto | buffer | image
  std::function<void(const std::string& step, float done)> progress;  ///< done in [0, 1]; may be empty
  std::function<void(const std::string&)> warning;                    ///< gets each of stats().warnings; may be empty
  TraceSink trace;  ///< gets every kernel, transfer and host step; may be empty
};

/// RGBA, linear, row after row from the top, premultiplied by nothing: alpha is the opacity in front of the background.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> pixels;
};

/// Writes an image in the format that the path's ending names; an earlier file stays if that fails. .png: clamped to
/// [0, 1], sRGB, rounded to 8 bits, without alpha; .exr: linear floats R G B A. Throws Error.
CDSM_API void writeImage(const std::string& path, const Image& image);

/// Of the light, at a point.
struct Transmittance {
  std::uint8_t lit;     ///< 0: outside of a spot light's cone
  float transmittance;  ///< 0 where not lit; the mean of the channels where shadows.transmittance is rgb
  glm::vec3 color;      ///< of red, green and blue light; all alike where shadows.transmittance is grey
};

/// Pictures of what is going on inside, as the camera sees it. Layers and steps do not depend on shadows; the others
/// need the technique "deep-shadow-map" and show one light's maps.
enum class DebugView {
  Clusters,  ///< objects in the colours of their clusters, shaded; grey: casts in none
  Nodes,     ///< nodes of the visibility functions of the texels in which the first visible point is looked up
  Layers,    ///< fragments along the ray, those of the boxes of volumes and those out of sight included, but for
             ///< what lies behind an opaque sphere
  Steps,     ///< samples of media shaded along the ray
  Texels,    ///< the picture with the texels of the map that the first visible point is looked up in, by cluster
};

struct ViewOptions {
  DebugView view = DebugView::Clusters;
  std::optional<std::string> light;  ///< name of the light whose maps are shown; none: the scene's first
};

/// Renders scenes and answers for the light at points. Holds device memory; one engine is used by one thread at a time,
/// several engines may live side by side. What is built for a scene is kept until a scene that differs is given.
class CDSM_API Engine {
 public:
  explicit Engine(const EngineOptions& options = {});
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  const DeviceDescription& device() const;

  /// The camera's image of the scene. Throws Error or DeviceError; the engine stays usable.
  Image render(const Scene& scene);

  /// The same into image.width * image.height values of the caller's, row after row from the top.
  void render(const Scene& scene, glm::vec4* pixels);

  /// A debug picture of the scene; maps are those of render(). Counts are colours of a scale from 0, dark, to the
  /// greatest count, bright: stats().view says which; black where there is nothing. Throws Error for an unknown light
  /// or a technique without maps.
  Image render(const Scene& scene, const ViewOptions& options);

  /// Transmittance from the light of that name to world points, in their order, as the scene's technique sees it and
  /// without bias [Knecht 2011, §3.3]. Throws Error for an unknown light.
  std::vector<Transmittance> transmittance(const Scene& scene, const std::string& light,
                                           const std::vector<glm::vec3>& points);

  /// Builds what queries for the scene need, as far as it has changed. Those below are about the last scene that any
  /// call was given, and compare nothing.
  void prepare(const Scene& scene);

  /// Transmittances of `count` points into `values`, channels() for each, -1 where the point is not lit. Both arrays
  /// are the caller's; where the device shares the host's memory they are used in place. Throws Error for a point that
  /// is not finite, and if no scene has been given or the last call with one failed: then prepare() comes first.
  void transmittance(const std::string& light, const glm::vec3* points, std::size_t count, float* values);

  /// Values of a point in that array: 1, or red, green and blue where the scene's shadows.transmittance is rgb. Throws
  /// Error if no scene is ready, as transmittance() does.
  std::size_t channels() const;

  /// Lets go of the scene: its device memory, and all that was kept of its data.
  void drop();

  /// The deep shadow maps of the light of that name, as transmittance() looks them up, in host memory. None if nothing
  /// that casts is in the light's reach. Throws Error for an unknown light, and if the scene's technique has no maps.
  std::vector<LightMap> lightMaps(const Scene& scene, const std::string& light);

  /// What the last call did: device times, maps, memory.
  const FrameStats& stats() const;

 private:
  struct Impl;
  friend struct EngineAccess;
  explicit Engine(std::unique_ptr<Impl> impl);
  Impl& impl() const;

  std::unique_ptr<Impl> impl_;
};

}  // namespace cdsm
