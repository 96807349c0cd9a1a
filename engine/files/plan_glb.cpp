#include "engine/files/plan_glb.h"

#include <glissade/version.h>

#include <algorithm>

#include "engine/files/glb_scene.h"

namespace glissade {
namespace {

constexpr double kStepSeconds = 2.0;
/// Least time between key frames, seconds. Single precision holds this difference up to half an hour of animation.
constexpr float kLeastStepTime = 2e-4F;

/// The configurations of a step in playback order.
std::vector<Pose> wayOf(const AssemblyStep& step, PlanOrder order) {
  std::vector<Pose> way;
  for (const PathPoint& point : step.path) way.push_back(point.q);
  if (order == PlanOrder::Assembly) std::reverse(way.begin(), way.end());
  return way;
}

/// Key frames of the step, delayed by `seconds`; the body stands still before them.
std::vector<KeyFrame> laterBy(double seconds, const std::vector<KeyFrame>& frames) {
  std::vector<KeyFrame> later{{0.0F, frames.front().q}};
  for (const KeyFrame& frame : frames) {
    const auto time = static_cast<float>(seconds + static_cast<double>(frame.time));
    later.push_back({std::max(time, later.back().time + kLeastStepTime), frame.q});
  }
  return later;
}

}  // namespace

Result<std::string> planAsGlb(const AssemblyPlan& plan, const AssembledProduct& product, PlanOrder order,
                              const std::string& name) {
  GlbBuilder glb(std::string("Glissade ") + kVersion);
  glb.json()["scene"] = 0;
  glb.json()["scenes"] = GlbBuilder::Json::array({{{"name", name}, {"nodes", GlbBuilder::Json::array({0})}}});
  const std::size_t world = addGlbWorld(glb);
  std::vector<std::size_t> nodes;
  for (const RigidBody& body : product.bodies) nodes.push_back(addGlbBody(glb, world, body, 1.0));
  std::vector<GlbTrack> tracks;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const AssemblyStep& step = plan.steps[order == PlanOrder::Assembly ? plan.steps.size() - 1 - i : i];
    const double begin = kStepSeconds * static_cast<double>(i);
    for (const std::size_t body : bodiesOf(step, product)) {
      const RigidBody& moved = product.bodies[body];
      const double radius = 0.5 * boundingBox(*moved.mesh).diagonal().norm();
      std::vector<KeyFrame> frames = keyFramesOf(wayOf(step, order), Se3Metric(radius), kStepSeconds);
      const Pose X_PB = inverse(step.path.front().q) * moved.X_WB;  // the path's frame may differ from the body's
      for (KeyFrame& frame : frames) frame.q = frame.q * X_PB;
      if (!isWithinSinglePrecision(frames)) {
        return Diagnostic{ErrorKind::MalformedInput, "", "",
                          GLISSADE_TEXT("a position of the plan is beyond single precision"),
                          GLISSADE_TEXT("Export the plan as JSON.")};
      }
      tracks.push_back({nodes[body], laterBy(begin, frames)});
    }
  }
  if (!tracks.empty()) addGlbAnimation(glb, order == PlanOrder::Assembly ? "Assembly" : "Removal", tracks);
  return glb.bytes();
}

}  // namespace glissade
