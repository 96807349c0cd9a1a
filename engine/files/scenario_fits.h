#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/evidence/thread.h"
#include "engine/files/scenario.h"
#include "engine/fits/assembled_product.h"
#include "engine/planning/path.h"

namespace glissade {

/// The product: the obstacles in their order, then the object's bodies at the start, in the frames that the scenario
/// gives them.
AssembledProduct bodiesOf(const LoadedScenario& scenario);

/// The obstacles in their order, then the object as the one body that moves. A person's statement about a body of a
/// group holds for the group where it is the stricter one: the least allowance applies, and a clash is accepted if it
/// is accepted for all bodies. For threads and kinds, the first statement applies.
AssembledProduct objectAndOthers(const LoadedScenario& scenario);

/// Finds the fits of the object by `scenario.scenario.fits`, and thins the object in the problem's world by their
/// allowances; existing fits are replaced. The product is taken as assembled in the start and, where it is a
/// configuration, in the goal. Called by loadGeometry(), and again after the settings have changed. Errors are those of
/// findObjectFits(), with the scenario's file.
Outcome applyFits(LoadedScenario& scenario, const StopToken& stop = {});

/// The problem's world without fits: clearance is required of every pair.
CollisionWorldPtr wholeWorld(const LoadedScenario& scenario);

/// Descriptions of the fits for which a certificate of this scenario's object holds: "nut taken 0.021 mm thinner on the
/// shaft of bolt (cylindrical)". Empty where the certificate is about the whole object. Threads have their turns on the
/// path, if one is given.
std::vector<Message> allowancesInWords(const LoadedScenario& scenario, const std::vector<PathPoint>& path = {});

/// These descriptions for files and reports: an array with one object for each fit, lengths in metres.
nlohmann::ordered_json allowancesJson(const LoadedScenario& scenario, const std::vector<PathPoint>& path = {});

/// A thread whose material is removed, as plans and paths state it.
nlohmann::ordered_json threadJson(const evidence::StatedThread& thread);

/// Full turns of the object on the path while it is in the thread of this fit, either way; 0 for other fits.
double turnsOn(const std::vector<PathPoint>& path, const LoadedScenario& scenario, const Fit& fit);

}  // namespace glissade
