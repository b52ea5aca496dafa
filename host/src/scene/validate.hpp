// SPDX-License-Identifier: Apache-2.0
// validate() in its parts, so that the scene file's reader can say at which place a part went wrong.
// Each throws Error naming the object, what is wrong and what would be right.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

#include "scene/data_checks.hpp"

namespace cdsm::scene {

/// validate() for scenes that follow each other: `checks` knows the data of those before.
void validateScene(const Scene& scene, DataChecks& checks);

void validateCamera(const Camera& camera);
void validateImage(const ImageSettings& image);

void validateSamples(int samples);
/// Numbers and the filter. Technique and memory strategy are the registry's to know, not the scene's.
void validateShadows(const ShadowSettings& shadows);

/// The technique has what it needs.
void validateTechnique(const Scene& scene);

/// Numbers of ambient occlusion, and that there are spheres.
void validateOcclusion(const Scene& scene);

void validateLight(const Light& light);
void validateMaterial(const Material& material);

/// Data, transform and material of a mesh, and that it is closed when it has an interior.
void validateMesh(const Mesh& mesh, std::size_t materialCount, DataChecks& checks);

/// Data, transform, boundary and transfer function. `meshes` are the scene's and valid themselves.
void validateVolume(const Volume& volume, const std::vector<Mesh>& meshes, DataChecks& checks);

/// Data, transform and material of spheres.
void validateSpheres(const Spheres& spheres, std::size_t materialCount, DataChecks& checks);

/// Positions finite, one normal or none per position, indices in range, at least one triangle.
void validateMeshData(const MeshData& data, const std::string& what);

/// As many bytes as voxels, no voxel NaN or infinite, an invertible grid.
void validateVolumeData(const VolumeData& data, const std::string& what);

/// At least one sphere, centres finite, a radius > 0 for each, one colour or none for each.
void validateSphereData(const SphereData& data, const std::string& what);

void validateTransferFunction(const TransferFunction& transfer, const std::string& what);

}  // namespace cdsm::scene
