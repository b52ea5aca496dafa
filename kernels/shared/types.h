// SPDX-License-Identifier: Apache-2.0
// Scalar and vector types of the structs that host and device share. The only header that asks who is reading.
// Shared structs hold float, int, uint, their 2- and 4-vectors and structs of these, vectors first, padding named.
#pragma once
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>

namespace cdsm::shared {
using uint = std::uint32_t;
struct alignas(8) int2 { int x = 0, y = 0; };
struct alignas(16) int4 { int x = 0, y = 0, z = 0, w = 0; };
struct alignas(8) uint2 { uint x = 0, y = 0; };
struct alignas(16) uint4 { uint x = 0, y = 0, z = 0, w = 0; };
struct alignas(8) float2 { float x = 0, y = 0; };
struct alignas(16) float4 {
  float x = 0, y = 0, z = 0, w = 0;
  float4() = default;
  float4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
  float4(const glm::vec3& v, float w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
};
}  // namespace cdsm::shared
#define CDSM_SHARED_BEGIN namespace cdsm::shared {
#define CDSM_SHARED_END }
#define CDSM_SIZE(Name, bytes) static_assert(sizeof(Name) == (bytes), "size of " #Name " differs from the device's")
#else
#define CDSM_SHARED_BEGIN
#define CDSM_SHARED_END
#define CDSM_SIZE(Name, bytes) typedef char sizeOf##Name[(sizeof(Name) == (bytes)) ? 1 : -1]
#endif
