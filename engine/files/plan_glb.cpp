#include "engine/files/plan_glb.h"

#include <glissade/version.h>

#include <algorithm>

#include "engine/files/glb_scene.h"

namespace glissade {
namespace {

constexpr double kStepSeconds = 2.0;
/// Least time between key frames, seconds. Single precision holds this difference up to half an hour of animation.
constexpr float kLeastStepTime = 2e-4F;

/// The configurations of a motion in playback order.
std::vector<Pose> wayOf(const StepMotion& motion, PlanOrder order) {
  std::vector<Pose> way;
  for (const PathPoint& point : motion.path) way.push_back(point.q);
  if (order == PlanOrder::Assembly) std::reverse(way.begin(), way.end());
  return way;
}

/// Key frames of a body of the motion.
std::vector<KeyFrame> framesOf(const StepMotion& motion, const RigidBody& body, PlanOrder order, double seconds) {
  const double radius = 0.5 * boundingBox(*body.mesh).diagonal().norm();
  std::vector<KeyFrame> frames = keyFramesOf(wayOf(motion, order), Se3Metric(radius), seconds);
  const Pose X_PB = inverse(motion.path.front().q) * body.X_WB;  // the path's frame may differ from the body's
  for (KeyFrame& frame : frames) frame.q = frame.q * X_PB;
  return frames;
}

/// Key frames of the motion, delayed by `seconds`; the body stands still before them.
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
    const double duration = kStepSeconds / static_cast<double>(step.motions.size());
    double begin = kStepSeconds * static_cast<double>(i);
    for (const StepMotion* motion : motionsOf(step, order)) {
      for (const std::size_t body : product.indicesOf(motion->bodies())) {
        const std::vector<KeyFrame> frames = framesOf(*motion, product.bodies[body], order, duration);
        if (!isWithinSinglePrecision(frames)) {
          return Diagnostic{ErrorKind::MalformedInput, "", "",
                            GLISSADE_TEXT("a position of the plan is beyond single precision"),
                            GLISSADE_TEXT("Export the plan as JSON.")};
        }
        tracks.push_back({nodes[body], laterBy(begin, frames)});
      }
      begin += duration;
    }
  }
  if (!tracks.empty()) addGlbAnimation(glb, order == PlanOrder::Assembly ? "Assembly" : "Removal", tracks);
  return glb.bytes();
}

}  // namespace glissade
