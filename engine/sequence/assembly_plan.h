#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/planning/path.h"
#include "engine/product/fit.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/tool_kind.h"

namespace glissade {

/// By how much a moving body of a step is taken thinner against one other body, or that one against it.
struct StepAllowance {
  std::string body;  ///< id of the other one
  ContactKind kind = ContactKind::Contact;
  double overlap = 0.0;        ///< as measured, metres
  double allowance = 0.0;      ///< metres
  std::string text;            ///< for people, with names
  std::string moving{};        ///< id of the body of the step; empty: its first one
  bool yields = false;         ///< the other one is taken thinner, not the moving one
  double pitch = 0.0;          ///< of a thread that comes apart by turning only, metres a turn; 0: none
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
    Place      ///< it comes at another place than the demanded one: nothing else can leave before
  };
  Rule rule = Rule::Before;
  std::vector<std::string> bodies;  ///< ids
};

/// The removal of one body, or of several that move as one. A motion that was proved against bodies is proved against
/// any of them.
struct AssemblyStep {
  std::string body;  ///< id, of a group the first one
  /// Of the frame that stands at the first configuration where the product is assembled: that of the body (see
  /// AssembledProduct), or of the group. Every body of the step has X_WB = X(t) X(0)^-1 X_WB(assembled).
  std::vector<PathPoint> path;
  /// "straight", "turned", "by hand" (kByHand), or "auto" and what found it: "auto: turning-rrt"
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

  std::size_t parts() const { return bodies.size() - staying.size(); }
  /// Bodies that leave.
  std::size_t removed() const {
    std::size_t count = 0;
    for (const AssemblyStep& step : steps) count += 1 + step.with.size();
    return count;
  }
};

}  // namespace glissade
