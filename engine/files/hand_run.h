#pragma once

#include <string>
#include <vector>

#include "engine/files/scenario.h"
#include "engine/sequence/demanded_steps.h"

namespace glissade {

/// Changes a product's scenario into the planning problem of one step. The bodies `moving` leave as one, and the bodies
/// `gone` have left before; both are ids of rigid bodies. The object turns about the middle of its bounding box, as
/// groups of a product's bodies do. `loaded` is the same scenario, loaded. `joints`: joints of the step. The threads
/// that the step unscrews are marked in the scenario, too, unless a person has set the kind of the pair. Errors, Usage:
/// a body in `moving` or `gone` is one of several links or parts that the scenario holds as one body.
Outcome prepareHandRun(const std::vector<BodyId>& moving, const std::vector<BodyId>& gone, const LoadedScenario& loaded,
                       const std::vector<StepJoint>& joints, Scenario& scenario);

/// The path of the object as the motion of these bodies of the product, which leave as one from the assembled product.
/// The motion counts as made by hand where a person has steered a part of it, else as found by the planner. The first
/// body names the step. Precondition: there is a body, and the path has two points.
DemandedMotion motionOfRun(const std::vector<RigidBody>& bodies, const std::vector<PathPoint>& path,
                           const PathProvenance& provenance);

}  // namespace glissade
