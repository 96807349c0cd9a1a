#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/message.h"
#include "engine/fits/allowance.h"
#include "engine/fits/fit.h"
#include "engine/fits/fit_thread.h"
#include "engine/fits/joint.h"
#include "engine/model/body_id.h"
#include "engine/planning/path.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// Whether a tool can be brought on when a motion begins.
enum class ToolAccess { NotAsked, Free, Blocked };

/// The tool that turns the fastener of a motion.
struct StepTool {
  ToolKind kind = ToolKind::None;
  ToolAccess access = ToolAccess::NotAsked;
  std::vector<BodyId> blockedBy{};  ///< ids of bodies in its way
  BodyId turned{};  ///< id of the bolt that it turns while the nut is held; empty: it turns the fastener
  BodyId held{};    ///< id of the nut or bolt on the other side of the joint, which is held meanwhile; empty: none
  ToolKind heldWith = ToolKind::None;  ///< tool that holds it; None: not known
};

/// A joint that comes apart by a motion: its description for people, and the conditions that the motion has to meet.
struct StepJoint {
  JointKind kind = JointKind::Screw;
  BodyId body;                    ///< id, see Joint::body
  std::vector<BodyId> others{};   ///< ids, see Joint::others
  std::vector<BodyId> clamped{};  ///< ids, see Joint::clamped
  std::string designation{};      ///< see Joint::designation
  DriveKind drive = DriveKind::None;
  double driveSize = 0.0;  ///< metres; 0: not known
  double diameter = 0.0;   ///< diameter of the thread, metres; 0: no thread
  double pitch = 0.0;      ///< metres a turn, below 0: left-handed; 0: no thread
  bool isPitchStated = false;
  double turns = 0.0;  ///< turns by which the motion opens the thread, >= 0 for either hand; 0: it does not turn
  double bend = 0.0;   ///< bend of the hook of a snap, metres

  bool operator==(const StepJoint&) const = default;
};

/// The proof of a motion: it keeps the required clearance from every body that was there.
struct StepProof {
  /// The bodies that were there: those that remain after this number of steps of the plan and the earlier motions of
  /// the own step.
  std::size_t afterSteps = 0;
  double required = 0.0;         ///< metres
  double provedClearance = 0.0;  ///< metres, lower bound; infinity: no body was there
  double minClearance = 0.0;     ///< smallest clearance that was met, metres
  BodyId nearest;                ///< id of the body at the smallest clearance; empty: none
};

/// A rule that a step breaks because a person wants the step at its place.
struct StepViolation {
  enum class Rule {
    Before,    ///< `bodies` are demanded to leave before
    Fastener,  ///< `bodies` are nuts that are still on the bolt that leaves
    Standing,  ///< `bodies` fall
    Place,     ///< the step has another place than the demanded one: no other body can leave before
    Joint      ///< `bodies` hold the step's bodies, as screws hold the parts that they clamp
  };
  Rule rule = Rule::Before;
  std::vector<BodyId> bodies;  ///< ids
};
inline constexpr EnumNames<StepViolation::Rule, 5> kRuleNames{{"before", "fastener", "standing", "place", "joint"}};

/// StepMotion::method of a flexible body; its motion is not proved.
inline constexpr const char* kFlexible = "flexible";

/// StepMotion::method for people.
Message methodInWords(const std::string& method);

/// A motion of a step: the removal of one body, or of several that move as one. A motion that is proved against a set
/// of bodies is proved against each subset.
struct StepMotion {
  BodyId body;  ///< id of the body, or of the first body of a group
  /// Path of the body's frame, or of the group's frame, from its pose in the assembled product (see AssembledProduct).
  /// Every body of the motion has X_WB = X(t) X(0)^-1 X_WB(assembled).
  std::vector<PathPoint> path;
  /// "straight", "two lines", "turned", "by hand" (kByHand), kFlexible, or "auto: " and the planner, as in "auto:
  /// turning-rrt".
  std::string method;
  StepProof proof;
  /// Allowances against bodies that were there, and against those that may be there in another order
  /// (AssemblyStep::after).
  std::vector<Allowance> allowances;
  std::vector<BodyId> with{};  ///< ids of the other bodies of a group

  FastenerKind fastener = FastenerKind::None;  ///< kind of a single body; None for a group
  StepTool tool{};                             ///< tool for a single body
  /// Ids of bodies that would tip or fall after the motion and do not before it: they have to be held.
  std::vector<BodyId> falling{};
  std::vector<StepJoint> joints{};  ///< joints that come apart by the motion
  bool unit = false;                ///< its bodies are held together by joints, and are not taken apart
  /// False for a flexible body: its path is for display, and is not proved.
  bool certified = true;

  /// Ids of all bodies that leave; the first body of the motion comes first.
  std::vector<BodyId> bodies() const {
    std::vector<BodyId> all{body};
    all.insert(all.end(), with.begin(), with.end());
    return all;
  }
};

/// A step of the work: motions that are carried out one after the other. A fastener stack is one step (joinStacks()).
struct AssemblyStep {
  std::vector<StepMotion> motions;  ///< at least one, in the order of removal
  std::size_t wave = 0;             ///< number from 1; steps of one wave were found together
  /// Numbers, from 1, ascending, of the steps that have to be carried out before this one: their bodies would be in the
  /// way, or the order is demanded. Every order that keeps `after` of all steps is proved as well.
  std::vector<std::size_t> after{};
  std::vector<StepViolation> violates{};  ///< broken rules of a step that a person has put at its place
  /// Number of the task, from 1: steps with the same number remove the fastener stacks of alike joints that clamp the
  /// same bodies. 0: it is a task alone.
  std::size_t task = 0;

  /// The motion of a step that has one, as all steps of a search have (see splitStacks()).
  StepMotion& only() { return motions.front(); }
  const StepMotion& only() const { return motions.front(); }
  /// Ids of all bodies that leave, in the order of the motions.
  std::vector<BodyId> bodies() const;
  /// The motion that opens the joint of the step with a tool; the first one where the step needs no tool.
  const StepMotion& opening() const;
  /// Ids of the bodies that fall by a motion of the step and that no motion of it removes; none twice.
  std::vector<BodyId> falling() const;
};

/// A body or a group for which a removal was searched and not found.
struct RefusedRemoval {
  BodyId body;                 ///< id of the body, or of the first body of a group
  int effort = 0;              ///< 0: straight motions; above 0: searches, each longer than the one of the effort below
  std::size_t afterSteps = 0;  ///< number of steps that had been carried out before the search
  std::vector<BodyId> blockedBy;  ///< ids; the search is repeated only after one of these bodies has left
  std::vector<BodyId> with{};     ///< ids of the other bodies of a group
};

/// The reason why a plan has ended.
enum class PlanEnd { Complete, Stuck, TimeLimit, Interrupted };
inline constexpr EnumNames<PlanEnd, 4> kPlanEndNames{{"complete", "stuck", "time_limit", "interrupted"}};

/// A body that stays because no removal was found.
struct StuckBody {
  BodyId body;  ///< id
  /// Ids of blocking bodies that are still there; for a step with a demanded place, those that were there at that
  /// place.
  std::vector<BodyId> blockedBy;
  Message reason{};  ///< with names; may be empty
};

/// The disassembly of a group that has left. It is planned in a frame of the group: only its bodies are there, at their
/// assembled poses.
struct SubassemblyLine {
  std::size_t step = 0;  ///< number, from 1, of the step by which the group has left, in the plan or in the line above
  std::vector<BodyId> bodies{};          ///< ids of all bodies of the group
  std::vector<BodyId> staying{};         ///< ids of the bodies that remain as the base
  std::vector<AssemblyStep> steps{};     ///< `after` counts the steps of this line
  std::vector<StuckBody> stuck{};        ///< bodies that could not leave the base
  std::vector<SubassemblyLine> lines{};  ///< lines of groups that leave this group
  Vector3 up = Vector3::UnitZ();         ///< upward direction of the work place, unit, frame of the product
};

/// An order in which the bodies of a product leave, each with a certified motion; assembly is the reverse. A value.
struct AssemblyPlan {
  std::string strategy;  ///< id of the strategy
  std::uint64_t seed = 1;
  std::vector<BodyId> bodies;     ///< ids of all bodies, in the order of the product
  std::vector<BodyId> staying;    ///< ids of bodies that do not leave
  Vector3 up = Vector3::UnitZ();  ///< upward direction of the work place, unit, frame of the product
  std::vector<AssemblyStep> steps;
  std::vector<RefusedRemoval> refusals;  ///< searches that a resumed run need not repeat
  /// Motions that a stopped run had found and not carried out, because bodies would fall.
  std::vector<StepMotion> waiting{};
  std::vector<StuckBody> stuck;
  PlanEnd end = PlanEnd::Complete;
  SequenceDemands demands{};
  double deflection = 0.0;  ///< deflection of the product's STEP file, metres; 0: chosen by the size of each part
  std::vector<SubassemblyLine> lines{};  ///< disassembly of groups that have left, in the order of the steps
  /// Ids of bodies that neither touch another body nor are joined to one: they may lie beside the product.
  std::vector<BodyId> isolated{};

  std::size_t parts() const { return bodies.size() - staying.size(); }
  /// Number of bodies that leave.
  std::size_t removed() const;
  /// Number of bodies that leave by a step that is not certified.
  std::size_t removedWithoutProof() const;
};

}  // namespace glissade
