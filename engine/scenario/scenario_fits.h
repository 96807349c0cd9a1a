#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/check/path.h"
#include "engine/planning/path.h"
#include "engine/product/assembled_product.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// The product: the obstacles in their order, then the object's bodies at the start, in the frames that the scenario
/// gives them.
AssembledProduct bodiesOf(const LoadedScenario& scenario);

/// The obstacles in their order, then the object as the one body that moves. What a person says of the bodies of a
/// group holds for the group where it asks for more, and where it is said of each of them: the least allowance of all,
/// and a clash that is accepted for all of them. Of threads, and of kinds, the first one counts.
AssembledProduct objectAndOthers(const LoadedScenario& scenario);

/// Finds the fits of the object as `scenario.scenario.fits` asks, and thins the object in the problem's world by what
/// they allow; fits that there were are replaced. The product is taken as assembled in the start and, where it is a
/// configuration, in the goal. Called by loadGeometry(); again where the settings were changed since.
/// Errors: as of findObjectFits(), with the scenario's file.
Outcome applyFits(LoadedScenario& scenario, const StopToken& stop = {});

/// The problem's world without fits: clearance is required of every pair.
CollisionWorldPtr wholeWorld(const LoadedScenario& scenario);

/// What a certificate of this scenario's object is about, for each fit in words: "nut taken 0.021 mm thinner on the
/// shaft of bolt (cylindrical)". Empty where the whole object is meant. Of threads with the turns of the path in them,
/// where there is one.
std::vector<std::string> allowancesInWords(const LoadedScenario& scenario, const std::vector<PathPoint>& path = {});

/// The same for files and reports: an array with an object a fit, lengths in metres.
nlohmann::ordered_json allowancesJson(const LoadedScenario& scenario, const std::vector<PathPoint>& path = {});

/// A thread that is taken away, as plans and paths state it.
nlohmann::ordered_json threadJson(const check::StatedThread& thread);

/// Full turns of the object on the path while it is in the thread of this fit, either way; 0 for other fits.
double turnsOn(const std::vector<PathPoint>& path, const LoadedScenario& scenario, const Fit& fit);

}  // namespace glissade
