#include "engine/scenario/path_glb.h"

#include <glissade/version.h>

#include <algorithm>
#include <cmath>

#include "engine/scenario/glb_builder.h"
#include "engine/scenario/path_animation.h"
#include "engine/scenario/path_text.h"

namespace glissade {
namespace {

using Json = GlbBuilder::Json;

constexpr double kSeconds = 10.0;
constexpr double kRoughness = 0.8;

/// glTF's colours are linear, ours sRGB.
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

/// Corners are not shared, so that edges stay hard; so there is nothing to index, and glTF takes them by threes.
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

std::size_t addBody(GlbBuilder& glb, const RigidBody& body, double opacity) {
  const std::size_t material = addMaterial(glb, body, opacity);
  const Json surface{{"attributes", surfaceOf(glb, *body.mesh)}, {"material", material}};
  const std::size_t mesh = glb.add("meshes", {{"name", body.name}, {"primitives", Json::array({surface})}});
  return glb.add("nodes", {{"name", body.name},
                           {"translation", coordinateList(body.X_WB.position)},
                           {"rotation", coordinateList(body.X_WB.orientation)},
                           {"mesh", mesh}});
}

/// The root node, which turns z up into y up, with all bodies below it. Returns the object's node.
std::size_t addBodies(GlbBuilder& glb, const LoadedScenario& scenario, const Pose& start) {
  const double half = std::sqrt(0.5);
  const std::size_t root = glb.add("nodes", {{"name", "World"}, {"rotation", {-half, 0.0, 0.0, half}}});
  Json children = Json::array();
  for (const RigidBody& body : scenario.obstacles) children.push_back(addBody(glb, body, kObstacleOpacity));
  RigidBody object = scenario.object;
  object.X_WB = start;
  children.push_back(addBody(glb, object, 1.0));
  const auto node = children.back().get<std::size_t>();
  glb.json()["nodes"][root]["children"] = std::move(children);
  return node;
}

void addAnimation(GlbBuilder& glb, const std::vector<KeyFrame>& frames, std::size_t node) {
  const auto count = static_cast<Eigen::Index>(frames.size());
  Eigen::MatrixXf times(1, count);
  Eigen::MatrixXf translations(3, count);
  Eigen::MatrixXf rotations(4, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const KeyFrame& frame = frames[static_cast<std::size_t>(i)];
    times(0, i) = frame.time;
    translations.col(i) = frame.q.position.cast<float>();
    rotations.col(i) = frame.q.orientation.coeffs().cast<float>();  // x y z w, as glTF
  }
  const auto numbers = [&](const Eigen::MatrixXf& values) {
    return glb.addNumbers(values, GlbBuilder::Use::KeyFrames);
  };
  const std::size_t input = numbers(times);
  const auto sampler = [&](const Eigen::MatrixXf& values) {
    return Json{{"input", input}, {"interpolation", "LINEAR"}, {"output", numbers(values)}};
  };
  const auto channel = [&](int index, const char* path) {
    return Json{{"sampler", index}, {"target", {{"node", node}, {"path", path}}}};
  };
  glb.add("animations", {{"name", "Path"},
                         {"samplers", {sampler(translations), sampler(rotations)}},
                         {"channels", {channel(0, "translation"), channel(1, "rotation")}}});
}

/// Larger numbers would be infinite in single precision.
bool isWithinSinglePrecision(const std::vector<KeyFrame>& frames) {
  return std::all_of(frames.begin(), frames.end(),
                     [](const KeyFrame& frame) { return frame.q.position.cast<float>().allFinite(); });
}

}  // namespace

Result<std::string> pathAsGlb(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance) {
  const std::vector<KeyFrame> frames = keyFramesOf(path.configurations(), scenario.problem.metric(), kSeconds);
  if (!isWithinSinglePrecision(frames)) {
    return Diagnostic{ErrorKind::MalformedInput, "", "", "a position of the path is beyond single precision",
                      "Export the path in another format."};
  }
  GlbBuilder glb(std::string("Glissade ") + kVersion);
  glb.json()["scene"] = 0;
  glb.json()["scenes"] = Json::array({{{"name", scenario.scenario.name},
                                       {"nodes", Json::array({0})},
                                       {"extras", provenanceJson(path, scenario, provenance)}}});
  addAnimation(glb, frames, addBodies(glb, scenario, frames.front().q));
  return glb.bytes();
}

}  // namespace glissade
