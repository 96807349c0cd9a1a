#pragma once

#include "engine/sequence/assembly_plan.h"

namespace glissade {

// Edits that a person makes to the steps of a plan, as demands for the next plan. Steps by index in the plan, bodies by
// id. The place of a fastener stack is demanded for its first motion; the rest of the stack follows it.

/// Moves the step to the place of `to`: see movedTo().
SequenceDemands withStepMoved(std::size_t from, std::size_t to, const AssemblyPlan& plan, SequenceDemands demands);

/// The order of the steps after that: see movedOrder().
std::vector<std::size_t> orderWithStepMoved(std::size_t from, std::size_t to, const AssemblyPlan& plan,
                                            const SequenceDemands& demands);

/// Locks or unlocks the place and the motions of the step; a motion by hand stays. Another step that is demanded at
/// this place moves to the next free place.
SequenceDemands withStepLocked(std::size_t step, bool locked, const AssemblyPlan& plan, SequenceDemands demands);

/// Forbids the direction to each of the bodies. Demands that exclude it stay: see demand_conflicts.h.
SequenceDemands withForbidden(const std::vector<BodyId>& bodies, const Vector3& direction, SequenceDemands demands);

/// Demands that each body of a list leaves before all bodies of the next list. Demands of the opposite order stay.
SequenceDemands withOrder(const std::vector<std::vector<BodyId>>& steps, SequenceDemands demands);

/// Demands this motion for the bodies, in place of earlier demanded motions of these bodies. Directions that forbid it
/// stay.
SequenceDemands withMotion(const DemandedMotion& motion, SequenceDemands demands);

/// Removes the demands on the places, motions, directions and order of these bodies.
SequenceDemands withoutDemandsOn(const std::vector<BodyId>& ids, SequenceDemands demands);

/// Demands on one step; null or empty members: there is none.
struct StepDemands {
  const DemandedPlace* place = nullptr;
  const DemandedMotion* motion = nullptr;  ///< the last one for a step of several motions
  std::vector<Vector3> forbidden{};
  std::vector<std::string> before{};  ///< names of bodies that leave after the step
  std::vector<std::string> after{};   ///< names of bodies that leave before the step

  bool isLocked() const { return place != nullptr && place->locked; }
  bool isByHand() const { return motion != nullptr && motion->method == kByHand; }
  bool isEmpty() const {
    return place == nullptr && motion == nullptr && forbidden.empty() && before.empty() && after.empty();
  }
};
/// Demands on the step of these bodies. The result refers to `demands`.
StepDemands demandsOn(const std::vector<BodyId>& ids, const SequenceDemands& demands);

}  // namespace glissade
