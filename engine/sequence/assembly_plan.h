#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/planning/path.h"
#include "engine/product/fit_settings.h"

namespace glissade {

/// By how much the moving body of a step is taken thinner against one other body.
struct StepAllowance {
  std::string body;  ///< id
  ContactKind kind = ContactKind::Contact;
  double overlap = 0.0;    ///< as measured, metres
  double allowance = 0.0;  ///< metres
  std::string text;        ///< for people, with names
  double pitch = 0.0;      ///< of a thread that comes apart by turning only, metres a turn; 0: none
  double turns = 0.0;      ///< of the body in it, by the right hand about the direction in which it leaves
};

/// What was proved of a step's motion: it keeps the required clearance from every body that was there.
struct StepProof {
  std::size_t afterSteps = 0;    ///< the bodies that were there: those that remain after so many steps of the plan
  double required = 0.0;         ///< metres
  double provedClearance = 0.0;  ///< metres, lower bound; infinity where nothing was there
  double minClearance = 0.0;     ///< metres, the smallest that was met
  std::string nearest;           ///< id of the body there; empty: none
};

/// The removal of one body. A motion that was proved against bodies is proved against any of them.
struct AssemblyStep {
  std::string body;             ///< id
  std::vector<PathPoint> path;  ///< of the body's frame, which stands at the first configuration; see AssembledProduct
  std::string method;           ///< "straight", "turned", or "auto" and what found it: "auto: turning-rrt"
  std::size_t wave = 0;         ///< steps of one wave were found together, from 1
  StepProof proof;
  std::vector<StepAllowance> allowances;  ///< against bodies that were there
};

/// A body whose removal was asked for and not found.
struct RefusedRemoval {
  std::string body;                    ///< id
  int effort = 0;                      ///< 0: straight motions; above: searches, each longer than the one before
  std::size_t afterSteps = 0;          ///< asked when these had been carried out
  std::vector<std::string> blockedBy;  ///< ids: it is not asked again with this effort before one of them has left
};

/// Why a plan has ended.
enum class PlanEnd { Complete, Stuck, TimeLimit, Interrupted };

/// A body that stays because no removal was found.
struct StuckBody {
  std::string body;                    ///< id
  std::vector<std::string> blockedBy;  ///< ids of those that are still there
};

/// In which order the bodies of a product leave, each with a certified motion; assembly is the reverse. A value.
struct AssemblyPlan {
  std::string strategy;  ///< id
  std::uint64_t seed = 1;
  std::vector<std::string> bodies;   ///< ids of all, as the product has them
  std::vector<std::string> staying;  ///< ids of those that are not to leave
  std::vector<AssemblyStep> steps;
  std::vector<RefusedRemoval> refusals;  ///< what a resumed search need not ask again
  std::vector<StuckBody> stuck;
  PlanEnd end = PlanEnd::Complete;

  std::size_t parts() const { return bodies.size() - staying.size(); }
};

}  // namespace glissade
