#pragma once

#include "engine/sequence/assembly_plan.h"

namespace glissade {

// What a person does to steps of a plan becomes demands of the next plan. Steps by index in the plan, bodies by id.

/// The step comes to stand where `to` is: see movedTo().
SequenceDemands withStepMoved(std::size_t from, std::size_t to, const AssemblyPlan& plan, SequenceDemands demands);

/// The step keeps its place and its motion, or not any more; a motion by hand stays. Another step that is wanted at its
/// place comes behind it.
SequenceDemands withStepLocked(std::size_t step, bool locked, const AssemblyPlan& plan, SequenceDemands demands);

/// None of the bodies leaves in the direction. Demands that exclude it stay: see demand_conflicts.h.
SequenceDemands withForbidden(const std::vector<std::string>& bodies, const Vector3& direction,
                              SequenceDemands demands);

/// Each body of one list leaves before all those of the next one. Demands of the other order stay.
SequenceDemands withOrder(const std::vector<std::vector<std::string>>& steps, SequenceDemands demands);

/// The bodies leave by this motion only, and by none that was demanded of them earlier. What forbids it stays.
SequenceDemands withMotion(const DemandedMotion& motion, SequenceDemands demands);

/// Nothing is demanded of the places, motions, directions and order of these bodies.
SequenceDemands withoutDemandsOn(const std::vector<std::string>& bodies, SequenceDemands demands);

/// What is demanded of a step; null where it is nothing.
struct StepDemands {
  const DemandedPlace* place = nullptr;
  const DemandedMotion* motion = nullptr;
  std::vector<Vector3> forbidden{};
  std::vector<std::string> before{};  ///< these leave after it
  std::vector<std::string> after{};   ///< these leave before it

  bool isLocked() const { return place != nullptr && place->locked; }
  bool isByHand() const { return motion != nullptr && motion->method == kByHand; }
  bool isEmpty() const {
    return place == nullptr && motion == nullptr && forbidden.empty() && before.empty() && after.empty();
  }
};
/// Refers to the demands.
StepDemands demandsOn(const std::vector<std::string>& bodies, const SequenceDemands& demands);

}  // namespace glissade
