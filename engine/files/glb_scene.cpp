#include "engine/files/glb_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "engine/base/json_reader.h"

namespace glissade {
namespace {

using Json = GlbBuilder::Json;

// The words of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint32_t kGlbVersion = 2;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

const char* typeOf(Eigen::Index rows) { return rows == 1 ? "SCALAR" : rows == 3 ? "VEC3" : "VEC4"; }

Json numberList(const Eigen::VectorXf& values) {
  Json list = Json::array();
  for (const float value : values) list.push_back(value);
  return list;
}

/// Little-endian, as are all machines that this runs on.
void append(std::string& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

void appendChunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
  append(bytes, content.size());
  append(bytes, kind);
  bytes += content;
}

using Json = GlbBuilder::Json;

constexpr double kRoughness = 0.8;

/// Converts a colour component from sRGB to linear, which glTF uses.
double linear(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

Json coordinateList(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
Json coordinateList(const Quaternion& q) { return {q.x(), q.y(), q.z(), q.w()}; }

std::size_t addMaterial(GlbBuilder& glb, const RigidBody& body, double opacity) {
  const Json colour{linear(body.colour[0]), linear(body.colour[1]), linear(body.colour[2]), opacity};
  Json material{
      {"name", body.name},
      {"pbrMetallicRoughness", {{"baseColorFactor", colour}, {"metallicFactor", 0.0}, {"roughnessFactor", kRoughness}}},
      {"doubleSided", true}};
  if (opacity < 1.0) material["alphaMode"] = "BLEND";
  return glb.add("materials", material);
}

/// Writes the triangles without an index: corners are not shared, so that edges stay hard, and glTF takes unindexed
/// corners in threes.
Json surfaceOf(GlbBuilder& glb, const TriangleMesh& mesh) {
  const auto corners = static_cast<Eigen::Index>(3 * mesh.triangles.size());
  Eigen::MatrixXf positions(3, corners);
  Eigen::MatrixXf normals(3, corners);
  Eigen::Index column = 0;
  for (const TriangleIndices& triangle : mesh.triangles) {
    const Vector3 normal = faceNormal(mesh, triangle);
    for (const std::uint32_t vertex : triangle) {
      positions.col(column) = mesh.vertices[vertex].cast<float>();
      normals.col(column++) = normal.cast<float>();
    }
  }
  return {{"POSITION", glb.addNumbers(positions, GlbBuilder::Use::Vertices)},
          {"NORMAL", glb.addNumbers(normals, GlbBuilder::Use::Vertices)}};
}

/// Adds a sampler for the translation and one for the rotation of a node.
void addTrack(GlbBuilder& glb, const GlbTrack& track, Json& animation) {
  const auto count = static_cast<Eigen::Index>(track.frames.size());
  Eigen::MatrixXf times(1, count);
  Eigen::MatrixXf translations(3, count);
  Eigen::MatrixXf rotations(4, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const KeyFrame& frame = track.frames[static_cast<std::size_t>(i)];
    times(0, i) = frame.time;
    translations.col(i) = frame.q.position.cast<float>();
    rotations.col(i) = frame.q.orientation.coeffs().cast<float>();  // order x y z w, as in glTF
  }
  const auto numbers = [&](const Eigen::MatrixXf& values) {
    return glb.addNumbers(values, GlbBuilder::Use::KeyFrames);
  };
  const std::size_t input = numbers(times);
  for (const auto& [path, values] : {std::pair("translation", &translations), std::pair("rotation", &rotations)}) {
    const std::size_t sampler = animation["samplers"].size();
    animation["samplers"].push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", numbers(*values)}});
    animation["channels"].push_back({{"sampler", sampler}, {"target", {{"node", track.node}, {"path", path}}}});
  }
}

}  // namespace

GlbBuilder::GlbBuilder(const std::string& generator) {
  json_["asset"] = {{"version", "2.0"}, {"generator", generator}};
}

std::size_t GlbBuilder::add(const char* list, Json entry) {
  json_[list].push_back(std::move(entry));
  return json_[list].size() - 1;
}

std::size_t GlbBuilder::addNumbers(const Eigen::MatrixXf& elements, Use use) {
  const std::size_t size = static_cast<std::size_t>(elements.size()) * sizeof(float);
  Json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}};
  if (use == Use::Vertices) view["target"] = kArrayBuffer;
  buffer_.append(reinterpret_cast<const char*>(elements.data()), size);
  return add("accessors", {{"bufferView", add("bufferViews", view)},
                           {"componentType", kFloat},
                           {"count", elements.cols()},
                           {"type", typeOf(elements.rows())},
                           {"min", numberList(elements.rowwise().minCoeff())},
                           {"max", numberList(elements.rowwise().maxCoeff())}});
}

Result<std::string> GlbBuilder::bytes() const {
  Json json = json_;
  json["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  std::string text = jsonText(json);
  text.resize((text.size() + 3) / 4 * 4, ' ');  // chunks are aligned; the buffer holds whole floats
  const std::size_t size = kHeaderBytes + 2 * kChunkHeaderBytes + text.size() + buffer_.size();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    return Diagnostic{ErrorKind::LimitReached, "", "",
                      GLISSADE_TEXT("the bodies have too many triangles for a GLB file (4 GiB)"),
                      GLISSADE_TEXT("Export the path in another format.")};
  }
  std::string bytes;
  bytes.reserve(size);
  append(bytes, kMagic);
  append(bytes, kGlbVersion);
  append(bytes, size);
  appendChunk(bytes, kJsonChunk, text);
  appendChunk(bytes, kBinaryChunk, buffer_);
  return bytes;
}

std::size_t addGlbWorld(GlbBuilder& glb) {
  const double half = std::sqrt(0.5);
  return glb.add("nodes", {{"name", "World"}, {"rotation", {-half, 0.0, 0.0, half}}});
}

std::size_t addGlbBody(GlbBuilder& glb, std::size_t world, const RigidBody& body, double opacity) {
  const std::size_t material = addMaterial(glb, body, opacity);
  const Json surface{{"attributes", surfaceOf(glb, *body.mesh)}, {"material", material}};
  const std::size_t mesh = glb.add("meshes", {{"name", body.name}, {"primitives", Json::array({surface})}});
  const std::size_t node = glb.add("nodes", {{"name", body.name},
                                             {"translation", coordinateList(body.X_WB.position)},
                                             {"rotation", coordinateList(body.X_WB.orientation)},
                                             {"mesh", mesh}});
  glb.json()["nodes"][world]["children"].push_back(node);
  return node;
}

void addGlbAnimation(GlbBuilder& glb, const char* name, const std::vector<GlbTrack>& tracks) {
  Json animation{{"name", name}, {"samplers", Json::array()}, {"channels", Json::array()}};
  for (const GlbTrack& track : tracks) addTrack(glb, track, animation);
  glb.add("animations", std::move(animation));
}

bool isWithinSinglePrecision(const std::vector<KeyFrame>& frames) {
  return std::all_of(frames.begin(), frames.end(),
                     [](const KeyFrame& frame) { return frame.q.position.cast<float>().allFinite(); });
}

}  // namespace glissade
