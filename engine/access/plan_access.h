#pragma once

#include <vector>

#include "engine/access/motion_access.h"

namespace glissade {

/// Of every step of a plan, or of a group that is taken apart, in its order.
struct LineAccess {
  std::vector<MotionAccess> steps{};
  std::vector<LineAccess> lines{};  ///< of the groups among them, in the order of AssemblyPlan::lines

  /// Steps, those of the groups too.
  std::size_t count() const;
  /// Of these the ones that a hand gets to, and of which enough is seen.
  std::size_t reached() const;
};

/// Of every step of a plan.
struct PlanAccess : LineAccess {
  Person person;
  MeshPtr forearm;  ///< of this person, in the forearm's frame
};

/// Asks of each step while those bodies are there that the steps before it have left; of a step of a group while the
/// others of the group are. Where the plan says that the step's tool is blocked, so is the hand. After a stop:
/// Interrupted. Precondition: the plan is about this product.
Result<PlanAccess> planAccess(const AssembledProduct& product, const AssemblyPlan& plan, const Person& person,
                              const WorkWatch& watch);

/// The object of a scenario along a path: the bodies are its obstacles, then the object. The place of assembly is that
/// end of the path at which the object is nearer to an obstacle; the motion goes from there to the other end.
struct PathAccess {
  MotionAccess motion;
  MeshPtr forearm;
  Pose X_WB;                 ///< of the object at the place
  bool beginsAtEnd = false;  ///< the place is the path's end
};
/// `path`: one configuration of the object or more. After a stop: Interrupted.
Result<PathAccess> pathAccess(const std::vector<RigidBody>& obstacles, RigidBody object, const std::vector<Pose>& path,
                              const Person& person, const WorkWatch& watch);

}  // namespace glissade
