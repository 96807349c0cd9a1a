#include "engine/sequence/step_tools.h"

#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/tool_shape.h"

namespace glissade {
namespace {

/// A tool in place, with the volume that its handle sweeps, and while it is brought on.
struct ToolMesh {
  MeshPtr inPlace;
  MeshPtr entering;
};

/// The meshes of the tools of a plan, each once: bodies with the same mesh share them.
class ToolMeshes {
 public:
  ToolMeshes(const AssemblyPlan& plan, const SequenceQuestion& question) {
    for (const AssemblyStep& step : plan.steps) {
      if (!turnsHead(step.only().tool.kind)) continue;
      for (const ToolUse& use : question.tools[question.product.indexOf(step.only().body)]) {
        const MeshPtr& mesh = question.product.bodies[use.turned].mesh;
        const auto [at, isNew] = heads_.try_emplace(mesh);
        if (isNew) at->second = headOf(*mesh);
        if (!at->second) continue;
        ToolMesh& tool = tools_[{mesh, use.kind}];
        if (tool.inPlace) continue;
        tool.inPlace = std::make_shared<const TriangleMesh>(toolShape(use.kind, *at->second));
        const auto entering = enteringToolShape(use.kind, *at->second);
        tool.entering = entering ? std::make_shared<const TriangleMesh>(*entering) : tool.inPlace;
      }
    }
  }

  /// Null if the body has none.
  const FastenerHead* head(const MeshPtr& mesh) const {
    const auto known = heads_.find(mesh);
    return known != heads_.end() && known->second ? &*known->second : nullptr;
  }
  const ToolMesh& tool(const MeshPtr& mesh, ToolKind kind) const { return tools_.at({mesh, kind}); }

 private:
  std::map<MeshPtr, std::optional<FastenerHead>> heads_;
  std::map<std::pair<MeshPtr, ToolKind>, ToolMesh> tools_;
};

using Blockers = std::vector<std::size_t>;

Blockers fewer(Blockers one, Blockers other) { return other.size() < one.size() ? std::move(other) : std::move(one); }

Blockers presentOf(const Blockers& blockers, const BodySet& there) {
  Blockers present;
  for (const std::size_t body : blockers) {
    if (there[body]) present.push_back(body);
  }
  return present;
}

}  // namespace

/// Bodies of the whole product that block one position of a handle; computed on demand.
struct ToolFacts::Position {
  std::optional<Blockers> inPlace{};
  std::vector<std::optional<Blockers>> ways{};  ///< blockers on each way to bring the tool on
};

/// One tool at the head of one step.
struct ToolFacts::Tool {
  ToolUse use;
  ToolMesh mesh;
  std::vector<std::size_t> others;  ///< all bodies except the turned one and those that leave
  std::vector<Pose> frames;         ///< frame of the tool for each position of its handle
  std::vector<Vector3> offWays;
  std::vector<Position> positions{};
};

struct ToolFacts::Step {
  std::size_t body = 0;     ///< the fastener
  std::vector<Tool> tools;  ///< the preferred one first
};

ToolFacts::ToolFacts(const AssemblyPlan& plan, const SequenceQuestion& question) : question_(question) {
  const ToolMeshes meshes(plan, question);
  for (const AssemblyStep& step : plan.steps) {
    steps_.emplace_back();
    if (!turnsHead(step.only().tool.kind)) continue;
    const std::size_t body = question.product.indexOf(step.only().body);
    steps_.back().body = body;
    for (const ToolUse& use : question.tools[body]) {
      const RigidBody& turned = question.product.bodies[use.turned];
      const FastenerHead* head = meshes.head(turned.mesh);
      if (head == nullptr) continue;
      Tool tool{use,
                meshes.tool(turned.mesh, use.kind),
                bodiesIn(without(without(question.initial(), {body}), {use.turned})),
                {},
                takeOffWays(use.kind, *head)};
      const int positions = handlePositions(use.kind);
      for (int i = 0; i < positions; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / positions;
        tool.frames.push_back(toolFrame(*head, turned.X_WB, exitDirection(step.only().path), turn));
      }
      tool.positions.resize(tool.frames.size(), {std::nullopt, {tool.offWays.size(), std::nullopt}});
      steps_.back().tools.push_back(std::move(tool));
    }
  }
}

ToolFacts::~ToolFacts() = default;

/// The result is not stored after a stop.
std::vector<std::size_t> ToolFacts::blocking(std::optional<std::vector<std::size_t>>& fact, const Placing& placing,
                                             const Tool& tool, const BodySet& there, const StopToken& stop) {
  if (fact) return presentOf(*fact, there);
  Blockers found = question_.trial.inTheWayOfTool(placing.mesh, placing.motion, tool.others, stop);
  Blockers present = presentOf(found, there);
  if (!stop.stopRequested()) fact = std::move(found);
  return present;
}

/// Bodies that block the tool in place in this position, or else on the best way to bring it on.
std::vector<std::size_t> ToolFacts::blockersAt(std::size_t position, Tool& tool, const BodySet& there,
                                               const StopToken& stop) {
  const Pose& X_WT = tool.frames[position];
  Position& facts = tool.positions[position];
  if (tool.mesh.entering != tool.mesh.inPlace) {
    Blockers inPlace = blocking(facts.inPlace, {tool.mesh.inPlace, {X_WT, X_WT}}, tool, there, stop);
    if (!inPlace.empty()) return inPlace;
  }
  std::optional<Blockers> best;
  for (std::size_t way = 0; way < tool.offWays.size(); ++way) {
    Pose off = X_WT;
    off.position += X_WT.orientation * tool.offWays[way];
    Blockers onWay = blocking(facts.ways[way], {tool.mesh.entering, {off, X_WT}}, tool, there, stop);
    best = best ? fewer(std::move(*best), std::move(onWay)) : std::move(onWay);
  }
  return best ? std::move(*best) : Blockers();
}

std::optional<StepTool> ToolFacts::toolOf(std::size_t number, const BodySet& there, const StopToken& stop) {
  Step& step = steps_[number];
  std::optional<StepTool> preferred;
  for (Tool& tool : step.tools) {
    std::optional<Blockers> fewest;
    for (std::size_t i = 0; i < tool.frames.size() && !(fewest && fewest->empty()); ++i) {
      Blockers blocking = blockersAt(i, tool, there, stop);
      fewest = fewest ? fewer(std::move(*fewest), std::move(blocking)) : std::move(blocking);
    }
    if (stop.stopRequested()) return std::nullopt;
    StepTool found{tool.use.kind, ToolAccess::Free, idsOf(*fewest, question_.product), {}};
    if (tool.use.turned != step.body) found.turned = question_.product.bodies[tool.use.turned].id;
    if (fewest->empty()) return found;
    found.access = ToolAccess::Blocked;
    if (!preferred) preferred = std::move(found);
  }
  return preferred;
}

namespace {

/// Finds what is held while the joint of a nut is opened: the fastener on the other side, with a tool for its head.
void addHeldSide(StepMotion& motion, const SequenceQuestion& question) {
  for (const StepJoint& joint : motion.joints) {
    if (joint.kind != JointKind::Nut || !motion.tool.turned.empty()) continue;
    for (const BodyId& other : joint.body == motion.body ? joint.others : std::vector<BodyId>{joint.body}) {
      const std::size_t side = question.product.indexOf(other);
      if (question.fasteners.empty() || question.fasteners[side] == FastenerKind::None) continue;
      motion.tool.held = other;
      const std::vector<ToolUse>& uses = question.tools[side];
      const bool isForHead = !uses.empty() && uses.front().turned == side;
      // The head of an equal part fits the same tool.
      const bool isEqual = question.product.bodies[side].mesh == question.product.body(motion.body).mesh;
      motion.tool.heldWith = !isForHead ? ToolKind::None : isEqual ? motion.tool.kind : uses.front().kind;
      return;
    }
  }
}

}  // namespace

void setTool(StepMotion& motion, ToolFacts& facts, std::size_t step, const BodySet& there,
             const SequenceQuestion& question, const StopToken& stop) {
  if (question.tools.empty() || !turnsHead(motion.tool.kind)) return;
  if (auto tool = facts.toolOf(step, there, stop)) motion.tool = std::move(*tool);
  addHeldSide(motion, question);
}

void addTools(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host) {
  if (question.tools.empty()) return;
  ToolFacts facts(plan, question);
  std::vector<BodyGroup> groups;
  for (const AssemblyStep& step : plan.steps) groups.push_back(groupOf(step, question.product));
  host.team().run(plan.steps.size(), [&](std::size_t i) {
    BodySet there = question.initial();
    for (std::size_t earlier = 0; earlier <= i; ++earlier) there = without(std::move(there), groups[earlier]);
    setTool(plan.steps[i].only(), facts, i, there, question, host.stopToken());
  });
}

}  // namespace glissade
