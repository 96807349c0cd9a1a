#pragma once

#include <string>
#include <vector>

#include "engine/scenario/scenario.h"
#include "engine/sequence/demanded_steps.h"

namespace glissade {

/// Makes of a product's scenario the question of one step: the bodies `moving` leave as one, those of `gone` are not
/// there any more. What moves turns about the middle of its bounding box, as groups of a product's bodies do. Both by
/// id of rigid bodies. `loaded` is the same scenario, loaded. `joints`: of the step; the threads that it turns out of
/// are marked in the run, too, where a person says nothing of them. Errors, Usage: a body that moves, or one that is
/// gone, is one of several links or parts that the scenario holds as one body.
Outcome prepareHandRun(const std::vector<std::string>& moving, const std::vector<std::string>& gone,
                       const LoadedScenario& loaded, const std::vector<StepJoint>& joints, Scenario& scenario);

/// The path of the object as the motion of these bodies of the product, which leave as one from where they are
/// assembled: by hand where a person has steered a part of it, else by the planner that found it. The first body
/// names the step. Precondition: there is a body, and the path has two points.
DemandedMotion motionOfRun(const std::vector<RigidBody>& bodies, const std::vector<PathPoint>& path,
                           const PathProvenance& provenance);

}  // namespace glissade
