#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/planning/path.h"
#include "engine/product/fit.h"
#include "engine/product/fit_thread.h"
#include "engine/product/joint.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// By how much a moving body of a step is taken thinner against one other body, or that one against it.
struct StepAllowance {
  std::string body;  ///< id of the other one
  ContactKind kind = ContactKind::Contact;
  double overlap = 0.0;                       ///< as measured, metres
  double allowance = 0.0;                     ///< metres
  std::string text;                           ///< for people, with names
  std::string moving{};                       ///< id of the body of the step; empty: its first one
  bool yields = false;                        ///< the other one is taken thinner, not the moving one
  bool hollow = false;                        ///< what the other body of the pair fills is taken away
  std::optional<check::StatedThread> core{};  ///< its thread, which is taken away against the other one
  double pitch = 0.0;                         ///< of a thread that comes apart by turning only, metres a turn; 0: none
  double turns = 0.0;          ///< of the body in it, by the right hand about the direction in which it leaves
  check::Evidence evidence{};  ///< what the largest allowance of the pair may rest on; all zero: the file does not say
};

/// Whether a tool can be brought on when a step begins.
enum class ToolAccess { NotAsked, Free, Blocked };

/// The tool that turns the fastener of a step.
struct StepTool {
  ToolKind kind = ToolKind::None;
  ToolAccess access = ToolAccess::NotAsked;
  std::vector<std::string> blockedBy{};  ///< ids of bodies in its way
  std::string turned{};  ///< id of the bolt that it turns while the step's nut is held; empty: it turns the fastener
};

/// A joint that comes apart by a step: what people read, and what has to be true of the step's motion.
struct StepJoint {
  JointKind kind = JointKind::Screw;
  std::string body;                    ///< id, as Joint::body
  std::vector<std::string> others{};   ///< ids, as Joint::others
  std::vector<std::string> clamped{};  ///< ids, as Joint::clamped
  std::string designation{};           ///< as Joint::designation
  DriveKind drive = DriveKind::None;
  double driveSize = 0.0;  ///< metres; 0: not known
  double diameter = 0.0;   ///< of the thread, metres; 0: it has none
  double pitch = 0.0;      ///< metres a turn, below 0: left-handed; 0: no thread
  bool isPitchStated = false;
  double turns = 0.0;  ///< that the step turns out of it, above 0 whatever the hand; 0: it does not turn
  double bend = 0.0;   ///< of the hook of a snap, metres

  bool operator==(const StepJoint&) const = default;
};

/// What was proved of a step's motion: it keeps the required clearance from every body that was there.
struct StepProof {
  std::size_t afterSteps = 0;    ///< the bodies that were there: those that remain after so many steps of the plan
  double required = 0.0;         ///< metres
  double provedClearance = 0.0;  ///< metres, lower bound; infinity where nothing was there
  double minClearance = 0.0;     ///< metres, the smallest that was met
  std::string nearest;           ///< id of the body there; empty: none
};

/// What a step does not keep because a person wants it at its place.
struct StepViolation {
  enum class Rule {
    Before,    ///< `bodies` are demanded to leave before
    Fastener,  ///< `bodies` are nuts that are still on it
    Standing,  ///< `bodies` fall
    Place,     ///< it comes at another place than the demanded one: nothing else can leave before
    Joint      ///< `bodies` hold it, as screws hold what they clamp
  };
  Rule rule = Rule::Before;
  std::vector<std::string> bodies;  ///< ids
};

/// AssemblyStep::method of a flexible body, of whose motion nothing is proved.
inline constexpr const char* kFlexible = "flexible";

/// The removal of one body, or of several that move as one. A motion that was proved against bodies is proved against
/// any of them.
struct AssemblyStep {
  std::string body;  ///< id, of a group the first one
  /// Of the frame that stands at the first configuration where the product is assembled: that of the body (see
  /// AssembledProduct), or of the group. Every body of the step has X_WB = X(t) X(0)^-1 X_WB(assembled).
  std::vector<PathPoint> path;
  /// "straight", "two lines", "turned", "by hand" (kByHand), or "auto" and what found it: "auto: turning-rrt";
  /// kFlexible
  std::string method;
  std::size_t wave = 0;  ///< steps of one wave were found together, from 1
  StepProof proof;
  /// Against bodies that were there, and those that may be there in another order (`after`).
  std::vector<StepAllowance> allowances;
  std::vector<std::string> with{};  ///< ids of the other bodies of a group
  /// Steps that have to be carried out before, by number from 1, ascending: their bodies would be in the way, or the
  /// order is demanded. Any order that keeps this of all steps is proved as well.
  std::vector<std::size_t> after{};

  FastenerKind fastener = FastenerKind::None;  ///< of a single body
  StepTool tool{};                             ///< of a single body
  /// Ids of bodies that stand before the step, and would tip or fall after it: they have to be held.
  std::vector<std::string> falling{};
  std::vector<StepViolation> violates{};  ///< of a step that a person has put at its place
  std::vector<StepJoint> joints{};        ///< that come apart by the step
  /// Steps of one task have the same number, from 1: alike joints that clamp the same bodies. 0: it is a task alone.
  std::size_t task = 0;
  bool unit = false;  ///< its bodies are one: joints hold them together, and nothing takes them apart
  /// False: of a flexible body. Its path is for the eye, and nothing is proved of it.
  bool certified = true;

  /// Ids of all bodies that leave, the first one first.
  std::vector<std::string> bodies() const {
    std::vector<std::string> all{body};
    all.insert(all.end(), with.begin(), with.end());
    return all;
  }
};

/// A body, or a group as one, whose removal was asked for and not found.
struct RefusedRemoval {
  std::string body;                    ///< id, of a group the first one
  int effort = 0;                      ///< 0: straight motions; above: searches, each longer than the one before
  std::size_t afterSteps = 0;          ///< asked when these had been carried out
  std::vector<std::string> blockedBy;  ///< ids: it is not asked again with this effort before one of them has left
  std::vector<std::string> with{};     ///< ids of the other bodies of a group
};

/// Why a plan has ended.
enum class PlanEnd { Complete, Stuck, TimeLimit, Interrupted };

/// A body that stays because no removal was found.
struct StuckBody {
  std::string body;  ///< id
  /// Ids of those that are still there; of a step that was demanded at a place, of those that were there then.
  std::vector<std::string> blockedBy;
  std::string reason{};  ///< for people, with names; may be empty
};

/// A group that has left, taken apart in a frame of its own: nothing but its bodies is there. They stand as they do
/// in the assembled product.
struct SubassemblyLine {
  std::size_t step = 0;                  ///< by which it has left, number from 1, of the plan or of the line above it
  std::vector<std::string> bodies{};     ///< ids of all
  std::vector<std::string> staying{};    ///< ids of those that the others are taken off
  std::vector<AssemblyStep> steps{};     ///< their numbers (`after`) are those of this line
  std::vector<StuckBody> stuck{};        ///< that remain together with those that stay
  std::vector<SubassemblyLine> lines{};  ///< of its groups
};

/// In which order the bodies of a product leave, each with a certified motion; assembly is the reverse. A value.
struct AssemblyPlan {
  std::string strategy;  ///< id
  std::uint64_t seed = 1;
  std::vector<std::string> bodies;   ///< ids of all, as the product has them
  std::vector<std::string> staying;  ///< ids of those that are not to leave
  std::vector<AssemblyStep> steps;
  std::vector<RefusedRemoval> refusals;  ///< what a resumed search need not ask again
  /// Of a search that was stopped: motions that were found and not carried out yet, because bodies would fall.
  std::vector<AssemblyStep> waiting{};
  std::vector<StuckBody> stuck;
  PlanEnd end = PlanEnd::Complete;
  SequenceDemands demands{};
  double deflection = 0.0;  ///< metres, that the product's STEP file was read with; 0: by the size of each part
  std::vector<SubassemblyLine> lines{};  ///< of the groups that have left, by step

  std::size_t parts() const { return bodies.size() - staying.size(); }
  /// Bodies that leave.
  std::size_t removed() const;
  /// Of them those that leave by a step that is not certified.
  std::size_t removedWithoutProof() const;
};

}  // namespace glissade
