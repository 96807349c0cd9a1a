#include "engine/import/formats/gltf_reader.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/geometry/vertex_welder.h"
#include "engine/import/formats/corner_mean.h"
#include "engine/import/formats/gltf_document.h"
#include "engine/import/formats/index_text.h"

namespace glissade {
namespace {

using Json = nlohmann::json;

enum Mode : std::uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

/// Extensions that only affect the appearance of a surface, and numbers of few bits, which are read.
constexpr std::array<std::string_view, 8> kHarmless{"KHR_materials_", "KHR_texture_",         "EXT_texture_",
                                                    "MSFT_texture_",  "KHR_lights_",          "EXT_lights_",
                                                    "KHR_xmp",        "KHR_mesh_quantization"};

void checkRequiredExtensions(const Json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return;
  for (const Json& extension : *required) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "";
    const bool harmless = std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view known) {
      return name.compare(0, known.size(), known) == 0;
    });
    if (!harmless)
      throw FormatError{"/extensionsRequired",
                        {GLISSADE_TEXT("requires the extension %1, which is not read"), {inQuotes(name)}}};
  }
}

/// The numbers of a list of length `count`; nothing if the list is missing.
std::optional<std::vector<double>> listOf(const Json& object, const char* key, std::size_t count,
                                          const std::string& location) {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  const bool numbers = found->is_array() && found->size() == count &&
                       std::all_of(found->begin(), found->end(), [](const Json& entry) { return entry.is_number(); });
  if (!numbers) throw FormatError{location, {GLISSADE_TEXT("has a '%1' that is not %2 numbers"), {key, count}}};
  return found->get<std::vector<double>>();
}

Eigen::Affine3d transformOf(const Json& node, const std::string& location) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (const auto matrix = listOf(node, "matrix", 16, location)) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix->data());
    return transform;
  }
  if (const auto t = listOf(node, "translation", 3, location)) transform.translate(Vector3((*t)[0], (*t)[1], (*t)[2]));
  if (const auto r = listOf(node, "rotation", 4, location)) {
    const Quaternion rotation((*r)[3], (*r)[0], (*r)[1], (*r)[2]);
    if (!(rotation.norm() > 0.0)) throw FormatError{location, GLISSADE_TEXT("has a rotation of length zero")};
    transform.rotate(rotation.normalized());
  }
  if (const auto s = listOf(node, "scale", 3, location)) transform.scale(Vector3((*s)[0], (*s)[1], (*s)[2]));
  return transform;
}

/// The corners of the triangles of a primitive, three a triangle.
std::vector<std::size_t> trianglesOf(std::uint64_t mode, const std::vector<std::size_t>& indices,
                                     const std::string& location) {
  const std::size_t count = indices.size();
  if (count < 3 || (mode == kTriangles && count % 3 != 0)) {
    throw FormatError{location, {GLISSADE_TEXT("has %1 corners, which are not whole triangles"), {count}}};
  }
  if (mode == kTriangles) return indices;
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i + 2 < count; ++i) {
    const std::size_t first = mode == kFan ? 0 : i;
    const bool turned = mode == kStrip && i % 2 == 1;
    corners.insert(corners.end(), {indices[first], indices[turned ? i + 2 : i + 1], indices[turned ? i + 1 : i + 2]});
  }
  return corners;
}

/// Collects the triangles of a scene.
class Scene {
 public:
  explicit Scene(const GltfDocument& document) : document_(document) {}

  MeshContent read() && {
    const Json& root = document_.root();
    checkRequiredExtensions(root);
    const std::uint64_t chosen = wholeNumber(root, "scene", "", 0);
    const Json& scene = document_.element("scenes", chosen);
    std::vector<Placed> open =
        childrenOf(scene, "nodes", "/scenes/" + std::to_string(chosen), Eigen::Affine3d::Identity());
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
      const Placed next = open.back();
      open.pop_back();
      std::vector<Placed> children = readNode(next);
      open.insert(open.end(), children.rbegin(), children.rend());
    }
    content_.mesh.vertices = std::move(welder_).takeVertices();
    content_.vertexMean = mean_.mean();
    return std::move(content_);
  }

 private:
  struct Placed {
    std::uint64_t node;
    Eigen::Affine3d parent;
  };

  /// A node may be reached once only: a node that is its ancestor would be read without end.
  std::vector<Placed> childrenOf(const Json& object, const char* key, const std::string& location,
                                 const Eigen::Affine3d& transform) {
    std::vector<Placed> children;
    const auto found = object.find(key);
    if (found == object.end()) return children;
    for (const Json& child : *found) {
      if (!child.is_number_unsigned()) throw FormatError{location, GLISSADE_TEXT("names a node that is not a number")};
      const auto node = child.get<std::uint64_t>();
      (void)document_.element("nodes", node);
      if (node >= reached_.size()) reached_.resize(node + 1, false);
      if (reached_[node])
        throw FormatError{location, {GLISSADE_TEXT("names node %1, which is in the scene already"), {node}}};
      reached_[node] = true;
      children.push_back({node, transform});
    }
    return children;
  }

  std::vector<Placed> readNode(const Placed& placed) {
    const std::string location = "/nodes/" + std::to_string(placed.node);
    const Json& node = document_.element("nodes", placed.node);
    const Eigen::Affine3d transform = placed.parent * transformOf(node, location);
    if (node.contains("extensions") && node["extensions"].contains("EXT_mesh_gpu_instancing")) {
      throw FormatError{location,
                        GLISSADE_TEXT("has instances by the extension 'EXT_mesh_gpu_instancing', which is not read")};
    }
    if (node.contains("skin")) {
      content_.warnings.push_back({GLISSADE_TEXT("%1: has a skin, which is not applied"), {location}});
    }
    if (node.contains("mesh")) readMesh(wholeNumber(node, "mesh", location), transform);
    return childrenOf(node, "children", location, transform);
  }

  void readMesh(std::uint64_t index, const Eigen::Affine3d& transform) {
    const std::string location = "/meshes/" + std::to_string(index);
    const Json& mesh = document_.element("meshes", index);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      throw FormatError{location, GLISSADE_TEXT("has no primitives")};
    for (std::size_t i = 0; i < primitives->size(); ++i) {
      readPrimitive((*primitives)[i], location + "/primitives/" + std::to_string(i), transform);
    }
  }

  void readPrimitive(const Json& primitive, const std::string& location, const Eigen::Affine3d& transform) {
    const std::uint64_t mode = wholeNumber(primitive, "mode", location, kTriangles);
    if (mode < kTriangles) return;  // points and lines
    if (mode > kFan) throw FormatError{location, {GLISSADE_TEXT("has the unknown mode %1"), {mode}}};
    if (primitive.contains("targets")) {
      content_.warnings.push_back({GLISSADE_TEXT("%1: has morph targets, which are not applied"), {location}});
    }
    const Json attributes = primitive.value("attributes", Json::object());
    const GltfNumbers positions = document_.numbers(wholeNumber(attributes, "POSITION", location), 3);
    const bool finite = std::all_of(positions.values.begin(), positions.values.end(),
                                    [](double coordinate) { return std::isfinite(coordinate); });
    if (!finite) throw FormatError{location, GLISSADE_TEXT("has a position that is not a finite number")};
    noteSpacing(positions, transform);
    const std::vector<std::size_t> corners =
        trianglesOf(mode, indicesOf(primitive, positions.values.size() / 3, location), location);
    addTriangles(corners, placed(positions, transform), attributesOf(attributes, location), transform);
  }

  void noteSpacing(const GltfNumbers& positions, const Eigen::Affine3d& transform) {
    if (!positions.single) return;
    double largest = 0.0;
    for (const double coordinate : positions.values) largest = std::max(largest, std::abs(coordinate));
    const Vector3 spacing = transform.linear().cwiseAbs() * Vector3::Constant(floatSpacing(largest));
    content_.coordinateSpacing = std::max(content_.coordinateSpacing, spacing.maxCoeff());
  }

  std::vector<std::size_t> indicesOf(const Json& primitive, std::size_t vertices, const std::string& location) const {
    std::vector<std::size_t> indices;
    if (!primitive.contains("indices")) {
      for (std::size_t i = 0; i < vertices; ++i) indices.push_back(i);
      return indices;
    }
    for (const double index : document_.numbers(wholeNumber(primitive, "indices", location), 1).values) {
      if (!(index >= 0.0 && index < static_cast<double>(vertices))) {
        throw FormatError{
            location, {GLISSADE_TEXT("has vertex %1 in its indices, but %2 vertices"), {indexText(index), vertices}}};
      }
      indices.push_back(static_cast<std::size_t>(index));
    }
    return indices;
  }

  static std::vector<Vector3> placed(const GltfNumbers& positions, const Eigen::Affine3d& transform) {
    std::vector<Vector3> points;
    points.reserve(positions.values.size() / 3);
    for (std::size_t i = 0; i < positions.values.size(); i += 3) {
      points.push_back(transform * Vector3(positions.values[i], positions.values[i + 1], positions.values[i + 2]));
    }
    return points;
  }

  /// Normals and texture coordinates are used for the mean only.
  struct Attributes {
    std::vector<double> normals;
    std::vector<double> textures;
  };
  Attributes attributesOf(const Json& attributes, const std::string& location) const {
    Attributes found;
    if (attributes.contains("NORMAL"))
      found.normals = document_.numbers(wholeNumber(attributes, "NORMAL", location), 3).values;
    if (attributes.contains("TEXCOORD_0")) {
      found.textures = document_.numbers(wholeNumber(attributes, "TEXCOORD_0", location), 2).values;
    }
    return found;
  }

  void addTriangles(const std::vector<std::size_t>& corners, const std::vector<Vector3>& points,
                    const Attributes& attributes, const Eigen::Affine3d& transform) {
    const bool mirrored = transform.linear().determinant() < 0.0;
    mean_.startSection();
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const Vector3& a = points[corners[i]];
      const Vector3 across = (points[corners[i + 1]] - a).cross(points[corners[i + 2]] - a);
      const Eigen::Vector3f flat = across.stableNormalized().cast<float>();
      TriangleIndices triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t corner = corners[i + k];
        triangle[k] = welder_.indexOf(points[corner]);
        mean_.add(triangle[k], points[corner], attributesAt(attributes, corner, flat));
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      content_.mesh.triangles.push_back(triangle);
    }
  }

  static CornerAttributes attributesAt(const Attributes& attributes, std::size_t corner, const Eigen::Vector3f& flat) {
    CornerAttributes found;
    found.normal = flat;
    if (3 * corner + 2 < attributes.normals.size()) {
      found.normal = Eigen::Map<const Vector3>(&attributes.normals[3 * corner]).cast<float>();
    }
    if (2 * corner + 1 < attributes.textures.size()) {
      found.texture = Eigen::Map<const Eigen::Vector2d>(&attributes.textures[2 * corner]).cast<float>();
    }
    return found;
  }

  const GltfDocument& document_;
  std::vector<bool> reached_;  ///< one entry for each node
  VertexWelder welder_;
  CornerMean mean_;
  MeshContent content_;
};

}  // namespace

MeshContent readGltf(std::string_view bytes) {
  try {
    const GltfDocument document(bytes);
    return Scene(document).read();
  } catch (const Json::exception&) {
    throw FormatError{"", GLISSADE_TEXT("has JSON values of the wrong types")};
  }
}

}  // namespace glissade
