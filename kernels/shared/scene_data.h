// SPDX-License-Identifier: Apache-2.0
// The scene on the device: triangles and spheres in object space, objects with their matrices, media (volumes and
// interiors).
#pragma once
#include "shared/types.h"

CDSM_SHARED_BEGIN

/// Affine map as three rows: result = (dot(x.xyz, p) + x.w, ...).
typedef struct Affine {
  float4 x, y, z;
} Affine;
CDSM_SIZE(Affine, 48);

/// A mesh, the box of a volume, or a set of spheres. Crossing its triangles enters and leaves its media.
typedef struct ObjectData {
  Affine worldFromObject;
  float4 diffuse;        ///< rgb, w: opacity of one crossing, 0..1; 0: no surface is seen
  float4 specular;       ///< rgb, w: shininess
  float4 transmission;   ///< rgb: of the light's colour where the surface interacts; if transmittance is rgb
  uint firstMedium;      ///< into the list of medium indices
  uint mediumCount;
  uint hasNormals;       ///< 0 | 1: the vertices of its triangles have normals
  uint encloses;         ///< 0 | 1: rays keep track of whether they are inside
  uint casts;            ///< 0 | 1: its surface and interior, or the volume of which it is the box, attenuate light
  uint receives;         ///< 0 | 1: the surface is shadowed
  uint hasColors;        ///< 0 | 1: its spheres have colours of their own, in place of diffuse
  uint hides;            ///< 0 | 1: nothing gets past a crossing of its surface
} ObjectData;
CDSM_SIZE(ObjectData, 128);

/// A sphere in the space of its object, whose matrix scales all axes alike.
typedef struct SceneSphere {
  float4 sphere;  ///< xyz: centre, w: radius
  float4 color;   ///< rgb, see ObjectData::hasColors; w: number of its object, as the bits of a float
} SceneSphere;
CDSM_SIZE(SceneSphere, 32);

/// A volume, or the constant interior of a closed mesh.
typedef struct MediumData {
  Affine indexFromWorld;  ///< of the volume: voxel centres are integers
  float4 specular;        ///< rgb, w: shininess
  float4 interior;        ///< constant medium: rgb, w: extinction in 1 / world length
  float4 attenuation;     ///< constant medium: of red, green and blue light on its way; if transmittance is rgb
  int4 size;              ///< voxels along x, y, z; w: volume slot, -1: constant medium
  int4 cells;             ///< macrocells along x, y, z; w: offset of its first macrocell
  float lutScale;         ///< transfer function: lut coordinate = value * lutScale + lutBias
  float lutBias;
  uint lutOffset;         ///< of its first entry
  uint lutLast;           ///< number of its last entry
  float step;             ///< ray step in world units: half the smallest voxel edge, or as the scene says
  uint shading;           ///< 0 | 1: Phong with the gradient as normal
  uint boxObject;         ///< volume cut by a mesh: object of its box, inside of which a ray must be too; else ~0
  uint receives;          ///< 0 | 1: it is shadowed
  uint firstShadowBlock;  ///< cache "volume": of this volume among those of a light, in CDSM_SHADOW_BLOCK voxels
  uint padding0, padding1, padding2;
} MediumData;
CDSM_SIZE(MediumData, 176);

/// Shadow volumes start at multiples of so many voxels, which lets 32 bits say where.
#define CDSM_SHADOW_BLOCK 64
/// A shadow volume's value for a transmittance of 1.
#define CDSM_SHADOW_ONE 65535.0f

/// Edge of a macrocell in voxels. A cell's bounds cover its 8 + 1 voxels per axis: all that its samples interpolate.
#define CDSM_MACROCELL 8

/// Steps that a ray may take in one segment; the host refuses scenes that would need more.
#define CDSM_MOST_STEPS 1048576

/// Cells of one volume and the table of its transfer function, for classifying them.
typedef struct CellParams {
  int4 cells;  ///< along x, y, z; w: offset of the first one
  float lutScale, lutBias;
  uint lutLast;
  uint padding;
} CellParams;
CDSM_SIZE(CellParams, 32);

CDSM_SHARED_END
