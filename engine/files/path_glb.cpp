#include "engine/files/path_glb.h"

#include <glissade/version.h>

#include "engine/files/glb_scene.h"
#include "engine/files/path_text.h"
#include "engine/files/product_name.h"

namespace glissade {
namespace {

using Json = GlbBuilder::Json;

constexpr double kSeconds = 10.0;
/// Adds the root node with all bodies below it. Returns the object's node.
std::size_t addBodies(GlbBuilder& glb, const LoadedScenario& scenario, const Pose& start) {
  const std::size_t root = addGlbWorld(glb);
  for (const RigidBody& body : scenario.obstacles) addGlbBody(glb, root, body, kObstacleOpacity);
  RigidBody object = scenario.object;
  object.X_WB = start;
  return addGlbBody(glb, root, object, 1.0);
}

}  // namespace

Result<std::string> pathAsGlb(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance) {
  const std::vector<KeyFrame> frames = keyFramesOf(path.configurations(), scenario.problem.metric(), kSeconds);
  if (!isWithinSinglePrecision(frames)) {
    return Diagnostic{ErrorKind::MalformedInput, "", "",
                      GLISSADE_TEXT("a position of the path is beyond single precision"),
                      GLISSADE_TEXT("Export the path in another format.")};
  }
  GlbBuilder glb(std::string("Glissade ") + kVersion);
  glb.json()["scene"] = 0;
  glb.json()["scenes"] = Json::array({{{"name", nameOfProduct(scenario)},
                                       {"nodes", Json::array({0})},
                                       {"extras", provenanceJson(path, scenario, provenance)}}});
  addGlbAnimation(glb, "Path", {{addBodies(glb, scenario, frames.front().q), frames}});
  return glb.bytes();
}

}  // namespace glissade
