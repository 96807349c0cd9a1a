#pragma once

#include <string>
#include <vector>

#include "engine/scenario/scenario.h"
#include "engine/sequence/demanded_steps.h"

namespace glissade {

/// Makes of a product's scenario the question of one step: the body `moving` leaves, those of `gone` are not there any
/// more. The object turns about the middle of its bounding box, as bodies of products do. Both by id of rigid bodies.
/// `loaded` is the same scenario, loaded. Errors, Usage: the body, or one that is gone, is one of several links or
/// parts that the scenario holds as one body.
Outcome prepareHandRun(const std::string& moving, const std::vector<std::string>& gone, const LoadedScenario& loaded,
                       Scenario& scenario);

/// The path of the object as the motion of the product's body, from where it is assembled: by hand where a person has
/// steered a part of it, else by the planner that found it. Precondition: the path has two points.
DemandedMotion motionOfRun(const RigidBody& body, const std::vector<PathPoint>& path, const std::string& planner);

}  // namespace glissade
