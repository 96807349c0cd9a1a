#include "engine/sequence/step_tools.h"

#include <map>
#include <numbers>
#include <optional>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/tool_shape.h"

namespace glissade {
namespace {

/// A tool where it turns the fastener, with what its handle sweeps, and while it is brought on.
struct ToolMesh {
  MeshPtr inPlace;
  MeshPtr entering;
};

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
        ToolMesh& tool = tools_[{mesh, kind}];
        if (tool.inPlace) continue;
        tool.inPlace = std::make_shared<const TriangleMesh>(toolShape(kind, *at->second));
        const auto entering = enteringToolShape(kind, *at->second);
        tool.entering = entering ? std::make_shared<const TriangleMesh>(*entering) : tool.inPlace;
      }
    }
  }

  /// Null where the body has none.
  const FastenerHead* head(const MeshPtr& mesh) const {
    const auto known = heads_.find(mesh);
    return known != heads_.end() && known->second ? &*known->second : nullptr;
  }
  const ToolMesh& tool(const MeshPtr& mesh, ToolKind kind) const { return tools_.at({mesh, kind}); }

 private:
  std::map<MeshPtr, std::optional<FastenerHead>> heads_;
  std::map<std::pair<MeshPtr, ToolKind>, ToolMesh> tools_;
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

using Blockers = std::vector<std::size_t>;

Blockers fewer(Blockers one, Blockers other) { return other.size() < one.size() ? std::move(other) : std::move(one); }

/// The question of one tool at one head.
struct ToolQuestion {
  ToolKind kind;
  const ToolMesh& mesh;
  const FastenerHead& head;
  const std::vector<std::size_t>& others;
  RemovalTrial& trial;
  const StopToken& stop;
};

/// What is in the way of a tool that is in place in this frame, or else of the best way to bring it on.
Blockers blockersAt(const Pose& X_WT, const ToolQuestion& tool) {
  if (tool.mesh.entering != tool.mesh.inPlace) {
    Blockers inPlace = tool.trial.inTheWayOfTool(tool.mesh.inPlace, {X_WT, X_WT}, tool.others, tool.stop);
    if (!inPlace.empty()) return inPlace;
  }
  std::optional<Blockers> best;
  for (const Vector3& way : takeOffWays(tool.kind, tool.head)) {
    Pose off = X_WT;
    off.position += X_WT.orientation * way;
    Blockers blocking = tool.trial.inTheWayOfTool(tool.mesh.entering, {off, X_WT}, tool.others, tool.stop);
    best = best ? fewer(std::move(*best), std::move(blocking)) : std::move(blocking);
  }
  return best ? std::move(*best) : Blockers();
}

/// Those of the position of the handle with the fewest.
Blockers blockersOf(const ToolQuestion& tool, const Pose& X_WB, const Vector3& exit) {
  std::optional<Blockers> fewest;
  const int positions = handlePositions(tool.kind);
  for (int i = 0; i < positions && !(fewest && fewest->empty()); ++i) {
    Blockers blocking = blockersAt(toolFrame(tool.head, X_WB, exit, 2.0 * std::numbers::pi * i / positions), tool);
    fewest = fewest ? fewer(std::move(*fewest), std::move(blocking)) : std::move(blocking);
  }
  return std::move(*fewest);
}

StepTool toolOf(const AssemblyStep& step, const std::vector<std::size_t>& others, const ToolMeshes& meshes,
                const SequenceQuestion& question, const StopToken& stop) {
  const std::size_t body = *question.product.indexOf(step.body);
  const RigidBody& own = question.product.bodies[body];
  const FastenerHead* head = meshes.head(own.mesh);
  if (head == nullptr) return step.tool;
  std::optional<StepTool> preferred;
  for (const ToolKind kind : question.tools[body]) {
    const ToolQuestion tool{kind, meshes.tool(own.mesh, kind), *head, others, question.trial, stop};
    const auto blocking = blockersOf(tool, own.X_WB, exitDirection(step.path));
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
