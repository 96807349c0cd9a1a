#include "engine/sequence/step_tools.h"

#include <map>
#include <numbers>
#include <optional>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/tool_shape.h"

namespace glissade {
namespace {

/// The meshes of the tools of a plan, each once: twins have the same.
class ToolMeshes {
 public:
  ToolMeshes(const AssemblyPlan& plan, const SequenceQuestion& question) {
    for (const AssemblyStep& step : plan.steps) {
      if (step.tool.kind == ToolKind::None) continue;
      const std::size_t body = *question.product.indexOf(step.body);
      const MeshPtr& mesh = question.product.bodies[body].mesh;
      const auto [at, isNew] = heads_.try_emplace(mesh);
      if (isNew) at->second = headOf(*mesh, question.fasteners[body]);
      if (!at->second) continue;
      for (const ToolKind kind : question.tools[body]) {
        MeshPtr& tool = tools_[{mesh, kind}];
        if (!tool) tool = std::make_shared<const TriangleMesh>(toolShape(kind, *at->second));
      }
    }
  }

  /// Null where the body has none.
  const FastenerHead* head(const MeshPtr& mesh) const {
    const auto known = heads_.find(mesh);
    return known != heads_.end() && known->second ? &*known->second : nullptr;
  }
  const MeshPtr& tool(const MeshPtr& mesh, ToolKind kind) const { return tools_.at({mesh, kind}); }

 private:
  std::map<MeshPtr, std::optional<FastenerHead>> heads_;
  std::map<std::pair<MeshPtr, ToolKind>, MeshPtr> tools_;
};

/// The frame of a tool at the head: a nut's tool comes from where the nut leaves to.
Pose toolFrame(const FastenerHead& head, const Pose& X_WB, const Vector3& exit, double turn) {
  Vector3 end = X_WB * head.end;
  Vector3 outwards = X_WB.orientation * head.outwards;
  if (head.bothEnds && outwards.dot(exit) < 0.0) {
    end -= head.height * outwards;
    outwards = -outwards;
  }
  Pose X_WT = Pose::translation(end);
  X_WT.orientation =
      Quaternion::FromTwoVectors(Vector3::UnitZ(), outwards) * Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitZ()));
  return X_WT;
}

/// What is in the way of a tool, the position of the handle with the fewest.
std::vector<std::size_t> blockersOf(ToolKind kind, const MeshPtr& mesh, const FastenerHead& head, const Pose& X_WB,
                                    const Vector3& exit, const std::vector<std::size_t>& others,
                                    const SequenceQuestion& question, const StopToken& stop) {
  std::optional<std::vector<std::size_t>> fewest;
  const int positions = handlePositions(kind);
  for (int i = 0; i < positions && !(fewest && fewest->empty()); ++i) {
    const Pose on = toolFrame(head, X_WB, exit, 2.0 * std::numbers::pi * i / positions);
    Pose off = on;
    off.position += takeOffLength(kind, head) * (on.orientation * Vector3::UnitZ());
    auto blocking = question.trial.inTheWayOfTool(mesh, {off, on}, others, stop);
    if (!fewest || blocking.size() < fewest->size()) fewest = std::move(blocking);
  }
  return *fewest;
}

StepTool toolOf(const AssemblyStep& step, const std::vector<std::size_t>& others, const ToolMeshes& meshes,
                const SequenceQuestion& question, const StopToken& stop) {
  const std::size_t body = *question.product.indexOf(step.body);
  const RigidBody& own = question.product.bodies[body];
  const FastenerHead* head = meshes.head(own.mesh);
  if (head == nullptr) return step.tool;
  std::optional<StepTool> preferred;
  for (const ToolKind kind : question.tools[body]) {
    const auto blocking = blockersOf(kind, meshes.tool(own.mesh, kind), *head, own.X_WB, exitDirection(step.path),
                                     others, question, stop);
    if (stop.stopRequested()) return step.tool;
    if (blocking.empty()) return {kind, ToolAccess::Free, {}};
    if (!preferred) preferred = {kind, ToolAccess::Blocked, idsOf(blocking, question.product)};
  }
  return *preferred;
}

}  // namespace

void addTools(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host) {
  if (question.tools.empty()) return;
  const ToolMeshes meshes(plan, question);
  std::vector<BodyGroup> groups;
  for (const AssemblyStep& step : plan.steps) groups.push_back(groupOf(step, question.product));
  host.team().run(plan.steps.size(), [&](std::size_t i) {
    AssemblyStep& step = plan.steps[i];
    if (step.tool.kind == ToolKind::None) return;
    BodySet there(question.product.bodies.size(), true);
    for (std::size_t earlier = 0; earlier <= i; ++earlier) there = without(std::move(there), groups[earlier]);
    step.tool = toolOf(step, bodiesIn(there), meshes, question, host.stopToken());
  });
}

}  // namespace glissade
