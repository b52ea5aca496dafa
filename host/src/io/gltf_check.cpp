// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 before assimp; see mesh_check.hpp. Only what leads to triangles is looked at.
#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/mesh_check.hpp"

namespace cdsm::io {

namespace {

using Json = nlohmann::json;

constexpr int kMaxJsonDepth = 64;    // assimp's JSON reader calls itself per level
constexpr int kMaxNodeDepth = 1000;  // as does its node reader

/// Component types of accessors, as glTF numbers them.
enum Component : std::uint64_t { kInt8 = 5120, kUInt8, kInt16, kUInt16, kUInt32 = 5125, kFloat = 5126 };

std::uint32_t littleEndian(const std::string& data, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i > 0; --i) value = value << 8 | static_cast<unsigned char>(data[at + i - 1]);
  return value;
}

class GltfCheck {
 public:
  explicit GltfCheck(const std::string& path) : path_(path) {}

  std::uint64_t run() {
    const std::string data = readText(path_);
    parse(hasEnding(path_, ".glb") ? jsonOfContainer(data) : data);
    checkVersion();
    for (const Json& buffer : list(document_, "buffers")) checkBuffer(buffer);
    for (const Json& view : list(document_, "bufferViews")) checkView(view);
    for (const Json& accessor : list(document_, "accessors")) checkAccessor(accessor);
    std::uint64_t faces = 0;
    for (const Json& mesh : list(document_, "meshes"))
      for (const Json& primitive : list(mesh, "primitives")) faces += checkPrimitive(primitive);
    checkNodes();
    return faces;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Error(Location{path_}, message); }

  /// A .glb is a header of 12 bytes, a JSON chunk and perhaps a binary chunk, each with a header of 8.
  std::string jsonOfContainer(const std::string& data) {
    if (data.size() < 20 || data.compare(0, 4, "glTF") != 0) fail("is not a binary glTF file; it must begin with glTF");
    const std::uint64_t jsonBytes = littleEndian(data, 12);
    if (littleEndian(data, 8) != data.size() || jsonBytes > data.size() - 20)
      fail("its size is not the one in its header; is the file cut short?");
    const std::size_t binary = 20 + jsonBytes;
    if (data.size() > binary) {
      if (data.size() < binary + 8 || littleEndian(data, binary) > data.size() - binary - 8)
        fail("its binary chunk is incomplete; is the file cut short?");
      binaryBytes_ = littleEndian(data, binary);
    }
    return data.substr(20, jsonBytes);
  }

  void parse(const std::string& text) {
    const auto shallow = [this](int depth, Json::parse_event_t, Json&) {
      if (depth > kMaxJsonDepth) fail("its JSON is nested too deeply to be a glTF file");
      return true;
    };
    try {
      document_ = Json::parse(text, shallow);
    } catch (const Json::exception& exception) {
      std::string reason = exception.what();
      reason.resize(std::min<std::size_t>(reason.find('\n'), std::min<std::size_t>(reason.size(), 120)));
      fail("its JSON cannot be read: " + reason);
    }
    if (!document_.is_object()) fail("its JSON is not an object");
  }

  void checkVersion() const {
    const Json asset = document_.value("asset", Json::object());
    if (!asset.is_object() || !asset.contains("version") || !asset["version"].is_string() ||
        asset["version"].get<std::string>().substr(0, 2) != "2.")
      fail("is not glTF 2.0; other versions are not read");
    for (const Json& extension : list(document_, "extensionsRequired")) {
      const std::string name = extension.is_string() ? extension.get<std::string>() : "";
      for (const char* packed : {"draco", "meshopt", "quantization"})
        if (name.find(packed) != std::string::npos)
          fail("needs " + name + ", which is not supported; write it without compression");
    }
  }

  /// An array of the object, empty if it has none.
  const Json& list(const Json& object, const char* key) const {
    static const Json none = Json::array();
    const auto at = object.find(key);
    if (at == object.end()) return none;
    if (!at->is_array()) fail(std::string("its ") + key + " are not an array");
    return *at;
  }

  std::uint64_t number(const Json& object, const char* key, std::uint64_t otherwise) const {
    if (!object.is_object()) fail("holds a list with something else than objects");
    const auto at = object.find(key);
    if (at == object.end()) return otherwise;
    if (!at->is_number_unsigned() || *at > UINT32_MAX) fail(std::string(key) + " is not a number of at most 32 bits");
    return at->get<std::uint64_t>();
  }

  /// What `object[key]` points to in the list of that name.
  const Json& target(const Json& object, const char* key, const char* listName) const {
    const std::uint64_t index = number(object, key, UINT64_MAX);
    const Json& items = list(document_, listName);
    if (index >= items.size())
      fail(std::string(key) + " points outside of " + listName + ", of which there are " +
           std::to_string(items.size()));
    return items[index];
  }

  void checkBuffer(const Json& buffer) const {
    const std::uint64_t claimed = number(buffer, "byteLength", 0);
    std::uint64_t held = binaryBytes_;
    if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
      if (!uri->is_string()) fail("the uri of a buffer is not a text");
      const std::string text = uri->get<std::string>();
      const bool isData = text.compare(0, 5, "data:") == 0;
      held = isData ? (text.size() - std::min(text.find(','), text.size())) / 4 * 3
                    : inputFileSize(besideHeader(path_, text));
    }
    if (claimed > held)
      fail("a buffer claims " + std::to_string(claimed) + " bytes, but " + std::to_string(held) + " are there");
  }

  void checkView(const Json& view) const {
    const std::uint64_t held = number(target(view, "buffer", "buffers"), "byteLength", 0);
    if (number(view, "byteOffset", 0) + number(view, "byteLength", 0) > held)
      fail("a bufferView reaches beyond its buffer");
  }

  std::uint64_t elementBytes(const Json& accessor) const {
    static const std::pair<const char*, std::uint64_t> kinds[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                                  {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const std::uint64_t type = number(accessor, "componentType", 0);
    const std::uint64_t bytes = type == kUInt32 || type == kFloat ? 4 : type == kInt16 || type == kUInt16 ? 2 : 1;
    for (const auto& [name, components] : kinds)
      if (accessor.contains("type") && accessor["type"] == name) return components * bytes;
    fail("an accessor has no known type");
  }

  void checkAccessor(const Json& accessor) const {
    const std::uint64_t count = number(accessor, "count", 0);
    if (accessor.contains("sparse")) fail("sparse accessors are not supported; write the mesh without them");
    const Json& view = target(accessor, "bufferView", "bufferViews");
    const std::uint64_t bytes = elementBytes(accessor);
    const std::uint64_t stride = number(view, "byteStride", bytes);
    const std::uint64_t end = count == 0 ? 0 : number(accessor, "byteOffset", 0) + (count - 1) * stride + bytes;
    if (count == 0 || stride < bytes || end > number(view, "byteLength", 0))
      fail("an accessor is empty or reaches beyond its bufferView");
  }

  /// assimp copies bytes where floats are not given.
  std::uint64_t checkFloats(const Json& attributes, const char* name) const {
    const Json& accessor = target(attributes, name, "accessors");
    if (accessor["type"] != "VEC3" || number(accessor, "componentType", 0) != kFloat)
      fail(std::string(name) + " is not made of three 32 bit floats");
    return number(accessor, "count", 0);
  }

  std::uint64_t checkPrimitive(const Json& primitive) const {
    const Json attributes = primitive.is_object() ? primitive.value("attributes", Json::object()) : Json::object();
    if (!attributes.is_object() || !attributes.contains("POSITION")) fail("a primitive has no POSITION");
    const std::uint64_t vertices = checkFloats(attributes, "POSITION");
    if (attributes.contains("NORMAL") && checkFloats(attributes, "NORMAL") != vertices)
      fail("a primitive has not as many NORMALs as POSITIONs");
    for (const auto& item : attributes.items()) target(attributes, item.key().c_str(), "accessors");
    if (!primitive.contains("indices")) return faceCount(primitive, vertices);
    const Json& indices = target(primitive, "indices", "accessors");
    const std::uint64_t type = number(indices, "componentType", 0);
    if (indices["type"] != "SCALAR" || (type != kUInt8 && type != kUInt16 && type != kUInt32))
      fail("the indices of a primitive are not unsigned integers");
    return faceCount(primitive, number(indices, "count", 0));
  }

  /// Points, lines and triangles by the primitive's mode; assimp makes a face of each.
  std::uint64_t faceCount(const Json& primitive, std::uint64_t corners) const {
    constexpr std::uint64_t kTriangles = 4;
    switch (number(primitive, "mode", kTriangles)) {
      case 0:
      case 2:
        return corners;
      case 1:
        return corners / 2;
      case 3:
        return corners - 1;
      case 4:
        if (corners % 3 != 0) fail("triangles with " + std::to_string(corners) + " corners; that is no multiple of 3");
        return corners / 3;
      case 5:
      case 6:
        return corners < 3 ? 0 : corners - 2;
      default:
        fail("the mode of a primitive is none of 0 to 6");
    }
  }

  /// Nodes must form trees of sensible depth, with the scenes' nodes at their roots.
  void checkNodes() const {
    const Json& nodes = list(document_, "nodes");
    std::vector<std::int64_t> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].is_object()) fail("a node is not an object");
      if (nodes[i].contains("mesh")) target(nodes[i], "mesh", "meshes");
      for (const Json& child : list(nodes[i], "children")) {
        std::int64_t& parent = parents[nodeIndex(child, nodes.size())];
        if (parent >= 0) fail("a node has two parents; nodes must form trees");
        parent = static_cast<std::int64_t>(i);
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      int depth = 0;
      for (std::int64_t at = parents[i]; at >= 0; at = parents[static_cast<std::size_t>(at)])
        if (++depth > kMaxNodeDepth) fail("its nodes form a circle, or are nested too deeply");
    }
    for (const Json& scene : list(document_, "scenes"))
      for (const Json& root : list(scene, "nodes"))
        if (parents[nodeIndex(root, nodes.size())] >= 0) fail("a scene shows a node that is not a root");
    if (document_.contains("scene")) target(document_, "scene", "scenes");
  }

  std::size_t nodeIndex(const Json& index, std::size_t nodes) const {
    if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= nodes)
      fail("a list of nodes points outside of nodes, of which there are " + std::to_string(nodes));
    return index.get<std::size_t>();
  }

  std::string path_;
  Json document_;
  std::uint64_t binaryBytes_ = 0;
};

}  // namespace

std::uint64_t checkGltf(const std::string& path) { return GltfCheck(path).run(); }

}  // namespace cdsm::io
