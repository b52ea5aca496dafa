// SPDX-License-Identifier: Apache-2.0
// The table of shared structs.
#include "struct_fields.hpp"

#include "shared/bvh_data.h"
#include "shared/debug_data.h"
#include "shared/frame_data.h"
#include "shared/layer_data.h"
#include "shared/map_data.h"
#include "shared/occlusion_data.h"
#include "shared/scene_data.h"
#include "shared/view_data.h"

namespace cdsm::kernels {
namespace {

using namespace shared;
using Scalars = std::vector<Scalar>;

Scalars numbers(int count, bool isFloat) {
  const char* const names[] = {".x", ".y", ".z", ".w"};
  Scalars scalars;
  for (int i = 0; i < count; ++i) scalars.push_back({count == 1 ? "" : names[i], std::size_t(i) * 4, isFloat});
  return scalars;
}

/// The numbers of a type; structs add theirs below.
template <class T>
Scalars scalarsOf();
template <>
Scalars scalarsOf<float>() {
  return numbers(1, true);
}
template <>
Scalars scalarsOf<float4>() {
  return numbers(4, true);
}
template <>
Scalars scalarsOf<int>() {
  return numbers(1, false);
}
template <>
Scalars scalarsOf<int2>() {
  return numbers(2, false);
}
template <>
Scalars scalarsOf<int4>() {
  return numbers(4, false);
}
template <>
Scalars scalarsOf<shared::uint>() {
  return numbers(1, false);
}

template <class T>
void append(Scalars& scalars, const std::string& name, std::size_t offset) {
  if constexpr (std::is_array_v<T>) {
    using Element = std::remove_extent_t<T>;
    for (std::size_t i = 0; i < std::extent_v<T>; ++i)
      append<Element>(scalars, name + "[" + std::to_string(i) + "]", offset + i * sizeof(Element));
  } else {
    for (const Scalar& part : scalarsOf<T>())
      scalars.push_back({"." + name + part.path, offset + part.offset, part.isFloat});
  }
}

#define CDSM_BEGIN(Name)      \
  template <>                 \
  Scalars scalarsOf<Name>() { \
    using Type = Name;        \
    Scalars s;
#define F(field) append<decltype(Type::field)>(s, #field, offsetof(Type, field));
#define CDSM_END \
  return s;      \
  }

CDSM_BEGIN(BvhNode)
F(low)
F(high)
F(link)
F(count)
F(padding0)
F(padding1)
CDSM_END CDSM_BEGIN(BvhPrimitive) F(a) F(b) F(c) CDSM_END

    CDSM_BEGIN(ViewData) F(pixelU) F(pixelV) F(pixelW) F(depth) F(origin) F(originU) F(originV) F(dir) F(dirU) F(dirV)
        F(width) F(height) F(tilesX) F(tilesY) F(nearDepth) F(initialCount) F(padding0) F(padding1) CDSM_END

    CDSM_BEGIN(WallParams) F(first) F(count) F(stride) F(padding) CDSM_END CDSM_BEGIN(OcclusionGrid) F(corner)
        F(size) CDSM_END CDSM_BEGIN(OcclusionParams) F(grid) F(levels) F(steps) F(directionCount) F(stepCount)
            F(firstCell) F(lastCell) F(buried) F(padding0) F(padding1) F(padding2) CDSM_END CDSM_BEGIN(DensityParams)
                F(grid) F(first) F(count) F(slices) F(padding) CDSM_END

    CDSM_BEGIN(BuildParams) F(view) F(tolerance) F(interiorStep) F(mapIndex) F(padding) CDSM_END CDSM_BEGIN(ShadeParams)
        F(view) F(ambient) F(interiorStep) F(bias) F(lightCount) F(lookupTolerance) F(occlusion) CDSM_END
    CDSM_BEGIN(QueryParams) F(pointCount) F(light) F(pointStride) F(padding) CDSM_END CDSM_BEGIN(MemoryParams)
        F(atlasSize) F(capacity) F(firstNode) F(scratchChunks) F(fill) F(nodesPerTexel) F(padding0) F(padding1)
            F(padding2) CDSM_END CDSM_BEGIN(TechniqueParams) F(memory) F(bilinear) F(mediumCount) F(nodeCount)
                F(texelBias) F(opaque) F(threshold) F(pcf) F(samples) F(patch) F(softness) F(softnessDistance)
                    F(softnessExponent) CDSM_END CDSM_BEGIN(DepthParams) F(view) F(threshold) F(firstTexel) F(seed)
                        F(patternX) F(patternY) F(jitter) F(channelShift) F(padding) CDSM_END CDSM_BEGIN(ProbeParams)
                            F(view) F(interiorStep) F(bias) F(light) F(padding) CDSM_END CDSM_BEGIN(MapProbe) F(seen)
                                F(nodes) F(map) F(checker) CDSM_END

    CDSM_BEGIN(ScreenTriangle) F(plane) F(a) F(b) F(c) F(minDepth) F(maxDepth) F(facing) F(padding0) F(padding1)
        F(padding2) CDSM_END CDSM_BEGIN(ScreenSphere) F(sphere) F(outline) F(reach) F(firstTile) F(lastTile) F(facing)
            F(minDepth) CDSM_END CDSM_BEGIN(RasterCounters) F(wanted) F(large) F(padding0) F(padding1) CDSM_END
    CDSM_BEGIN(SetupParams) F(first) F(count) F(capacity) F(leastRadius) CDSM_END

    CDSM_BEGIN(LightData) F(position) F(axis) F(color) F(firstMap) F(mapCount) F(type) F(front) F(formerCount) F(share)
        F(firstShadowBlock) F(mediumCount) CDSM_END CDSM_BEGIN(MapData) F(texelU) F(texelV) F(texelW) F(depth) F(origin)
            F(originU) F(originV) F(dir) F(dirU) F(dirV) F(atlasOffset) F(width) F(height) F(firstTexel) F(firstNode)
                F(nearDepth) F(face) F(wideTable) F(firstTile) CDSM_END CDSM_BEGIN(BuildCounters) F(chunks) F(maxNodes)
                    F(maxTileNodes) F(unfilledTiles) F(nodesLow) F(nodesHigh) F(roomLow) F(roomHigh) CDSM_END

    CDSM_BEGIN(Affine) F(x) F(y) F(z) CDSM_END CDSM_BEGIN(ObjectData) F(worldFromObject) F(diffuse) F(specular)
        F(transmission) F(firstMedium) F(mediumCount) F(hasNormals) F(encloses) F(casts) F(receives) F(hasColors)
            F(hides) CDSM_END CDSM_BEGIN(SceneSphere) F(sphere) F(color) CDSM_END
    CDSM_BEGIN(MediumData) F(indexFromWorld) F(specular) F(interior) F(attenuation) F(size) F(cells) F(lutScale)
        F(lutBias) F(lutOffset) F(lutLast) F(step) F(shading) F(boxObject) F(receives) F(firstShadowBlock) F(padding0)
            F(padding1) F(padding2) CDSM_END CDSM_BEGIN(FillParams) F(worldFromIndex) F(firstCell) F(light) F(medium)
                F(padding) CDSM_END CDSM_BEGIN(CellParams) F(cells) F(lutScale) F(lutBias) F(lutLast)
                    F(padding) CDSM_END

    template <class T>
    SharedStruct entry(const char* name, const char* header) {
  return {name, header, sizeof(T), scalarsOf<T>()};
}

}  // namespace

#define CDSM_ENTRY(Name, header) entry<Name>(#Name, "shared/" header)

std::vector<SharedStruct> sharedStructs() {
  return {CDSM_ENTRY(BvhNode, "bvh_data.h"),
          CDSM_ENTRY(BvhPrimitive, "bvh_data.h"),
          CDSM_ENTRY(BuildParams, "frame_data.h"),
          CDSM_ENTRY(ShadeParams, "frame_data.h"),
          CDSM_ENTRY(DepthParams, "frame_data.h"),
          CDSM_ENTRY(QueryParams, "frame_data.h"),
          CDSM_ENTRY(TechniqueParams, "frame_data.h"),
          CDSM_ENTRY(ScreenSphere, "layer_data.h"),
          CDSM_ENTRY(SceneSphere, "scene_data.h"),
          CDSM_ENTRY(FillParams, "frame_data.h"),
          CDSM_ENTRY(ScreenTriangle, "layer_data.h"),
          CDSM_ENTRY(RasterCounters, "layer_data.h"),
          CDSM_ENTRY(SetupParams, "layer_data.h"),
          CDSM_ENTRY(LightData, "map_data.h"),
          CDSM_ENTRY(MapData, "map_data.h"),
          CDSM_ENTRY(MemoryParams, "map_data.h"),
          CDSM_ENTRY(BuildCounters, "map_data.h"),
          CDSM_ENTRY(Affine, "scene_data.h"),
          CDSM_ENTRY(ObjectData, "scene_data.h"),
          CDSM_ENTRY(MediumData, "scene_data.h"),
          CDSM_ENTRY(CellParams, "scene_data.h"),
          CDSM_ENTRY(ViewData, "view_data.h"),
          CDSM_ENTRY(ProbeParams, "debug_data.h"),
          CDSM_ENTRY(MapProbe, "debug_data.h"),
          CDSM_ENTRY(OcclusionGrid, "occlusion_data.h"),
          CDSM_ENTRY(WallParams, "layer_data.h"),
          CDSM_ENTRY(OcclusionParams, "occlusion_data.h"),
          CDSM_ENTRY(DensityParams, "occlusion_data.h")};
}

}  // namespace cdsm::kernels
