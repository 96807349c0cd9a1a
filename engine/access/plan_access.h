#pragma once

#include <vector>

#include "engine/access/motion_access.h"

namespace glissade {

/// Access to the motion of a step that decides: the first one without access, else the one that the tool opens.
struct StepAccess : MotionAccess {
  std::size_t motion = 0;  ///< index of the motion in the step
};

/// Access to each step of a plan, or of a group that is taken apart, in its order.
struct LineAccess {
  std::vector<StepAccess> steps{};
  std::vector<LineAccess> lines{};  ///< access to the groups' steps, in the order of AssemblyPlan::lines

  /// Number of steps, including those of groups.
  std::size_t count() const;
  /// Number of steps with access for the hand and sufficient visibility.
  std::size_t reached() const;
};

/// Access to each step of a plan.
struct PlanAccess : LineAccess {
  Person person;
  MeshPtr forearm;  ///< forearm of this person, in the forearm's frame
};

/// Tests each motion while the bodies are there that those before it have left; a step of a group while the other
/// bodies of the group are. If the plan states that the motion's tool is blocked, the hand is blocked, too. After a
/// stop: Interrupted. Precondition: the plan belongs to this product.
Result<PlanAccess> planAccess(const AssembledProduct& product, const AssemblyPlan& plan, const Person& person,
                              const WorkWatch& watch);

/// Access to the object of a scenario along a path: the bodies are its obstacles, then the object. The place of
/// assembly is the end of the path where the object is nearer to an obstacle; the motion leads from there to the other
/// end.
struct PathAccess {
  MotionAccess motion;
  MeshPtr forearm;
  Pose X_WB;                 ///< pose of the object at the place of assembly
  bool beginsAtEnd = false;  ///< the place of assembly is the path's end
};
/// `path`: one or more configurations of the object. After a stop: Interrupted.
Result<PathAccess> pathAccess(const std::vector<RigidBody>& obstacles, RigidBody object, const std::vector<Pose>& path,
                              const Person& person, const WorkWatch& watch);

}  // namespace glissade
