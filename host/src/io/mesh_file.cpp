// SPDX-License-Identifier: Apache-2.0
// Meshes through assimp; see mesh_file.hpp.
#include "io/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/mesh_check.hpp"
#include "io/mesh_soup.hpp"
#include "io/text_numbers.hpp"

namespace cdsm::io {

namespace {

using Check = std::uint64_t (*)(const std::string&);

Check checkFor(const std::string& path) {
  if (hasEnding(path, ".obj")) return checkObj;
  if (hasEnding(path, ".ply")) return checkPly;
  if (hasEnding(path, ".stl")) return checkStl;
  if (hasEnding(path, ".gltf") || hasEnding(path, ".glb")) return checkGltf;
  throw Error(Location{path},
              "is not known as a mesh by its ending; meshes are read from .obj, .ply, .stl, .gltf and .glb");
}

std::string reason(const Assimp::Importer& importer) {
  const std::string text = printable(importer.GetErrorString());
  return text.empty() ? "no reason given" : text;
}

/// assimp's steps after reading trust the faces and abort the process on some, so these are checked first.
void checkFace(const std::string& path, const aiMesh& mesh, unsigned index) {
  const aiFace& face = mesh.mFaces[index];
  const std::string name = "face " + std::to_string(index) + " (from 0) of mesh " + quoted(mesh.mName.C_Str());
  if (face.mNumIndices == 0) throw Error(Location{path}, name + " has no vertices; a face has at least three");
  for (unsigned i = 0; i < face.mNumIndices; ++i)
    if (face.mIndices[i] >= mesh.mNumVertices)
      throw Error(Location{path}, name + " uses vertex " + std::to_string(face.mIndices[i]) + ", but there are " +
                                      std::to_string(mesh.mNumVertices));
}

void checkFaces(const std::string& path, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f) checkFace(path, *scene.mMeshes[m], f);
}

/// assimp drops faces that it does not understand; a file that has them is refused.
void checkFaceCount(const std::string& path, const aiScene& scene, std::uint64_t faces) {
  std::uint64_t found = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) found += scene.mMeshes[m]->mNumFaces;
  if (found < faces)
    throw Error(Location{path}, std::to_string(faces - found) + " of its " + std::to_string(faces) +
                                    " faces cannot be used; they name vertices that do not exist, or too few of them");
}

const aiScene& load(Assimp::Importer& importer, const std::string& path, std::uint64_t faces) {
  const aiScene* scene = importer.ReadFile(path, 0);
  if (!scene || !scene->mRootNode || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0)
    throw Error(Location{path}, "cannot be read as a mesh: " + reason(importer));
  checkFaces(path, *scene);
  checkFaceCount(path, *scene, faces);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (!scene) throw Error(Location{path}, "cannot be cut into triangles: " + reason(importer));
  return *scene;
}

glm::mat4 toGlm(const aiMatrix4x4& m) {
  return glm::mat4(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4);
}

/// Cofactors: normals turn with them under every matrix, also one that cannot be inverted.
glm::mat3 normalMatrix(const glm::mat4& m) {
  const glm::mat3 axes(m);
  return glm::mat3(glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]), glm::cross(axes[0], axes[1]));
}

class CornerCollector {
 public:
  CornerCollector(std::string path, bool normals) : path_(std::move(path)), normals_(normals) {}

  void add(const aiMesh& mesh, const glm::mat4& transform) {
    const glm::mat3 turned = normalMatrix(transform);
    const bool mirrored = glm::determinant(glm::mat3(transform)) < 0.0f;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      for (unsigned i = 0; i < 3; ++i) {
        const unsigned index = face.mIndices[mirrored ? 2 - i : i];  // a mirrored triangle turns its back otherwise
        corners.push_back(corner(mesh, index, transform, mirrored ? -turned : turned));
      }
    }
  }

  std::vector<Corner> corners;

 private:
  Corner corner(const aiMesh& mesh, unsigned index, const glm::mat4& transform, const glm::mat3& turned) const {
    const aiVector3D& p = mesh.mVertices[index];
    Corner corner{glm::vec3(transform * glm::vec4(p.x, p.y, p.z, 1.0f)), glm::vec3(0.0f)};
    if (normals_ && mesh.HasNormals()) {
      const aiVector3D& n = mesh.mNormals[index];
      corner.normal = turned * glm::vec3(n.x, n.y, n.z);
    }
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(corner.position[i]) || !std::isfinite(corner.normal[i]))
        throw Error(Location{path_}, "vertex " + std::to_string(index) + " (from 0) of mesh " +
                                         quoted(mesh.mName.C_Str()) + " has a position or normal that is not finite");
    return corner;
  }

  std::string path_;
  bool normals_;
};

/// Adds every mesh once for each node that shows it.
void collect(const aiScene& scene, CornerCollector& collector) {
  std::vector<std::pair<const aiNode*, glm::mat4>> open = {{scene.mRootNode, glm::mat4(1.0f)}};
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const glm::mat4 transform = parent * toGlm(node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) collector.add(*scene.mMeshes[node->mMeshes[i]], transform);
    for (unsigned i = node->mNumChildren; i > 0; --i) open.emplace_back(node->mChildren[i - 1], transform);
  }
}

}  // namespace

std::shared_ptr<const MeshData> readMesh(const std::string& path) {
  const Check check = checkFor(path);
  inputFileSize(path);
  const std::uint64_t faces = check(path);
  Assimp::Importer importer;
  const aiScene& scene = load(importer, path, faces);
  CornerCollector collector(path, !hasEnding(path, ".stl"));
  collect(scene, collector);
  auto mesh = std::make_shared<MeshData>(joinCorners(collector.corners));
  if (mesh->triangles.empty())
    throw Error(Location{path}, "holds no triangle with an area; points and lines cannot be rendered");
  return mesh;
}

}  // namespace cdsm::io
