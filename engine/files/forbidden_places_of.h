#pragma once

#include "engine/base/stop_token.h"
#include "engine/check/product.h"
#include "engine/files/scenario.h"

namespace glissade {

/// The places among the loaded bodies that the edits of `content` forbid, as its file states them. The places are
/// computed anew, so that the boxes are those of the present arrangement. Errors: those of Prohibitions::of().
Result<ForbiddenPlaces> forbiddenPlacesOf(const LoadedScenario& loaded, const Scenario& content,
                                          const StopToken& stop = {});

/// A warning that the file does not state these places; nothing where it does.
std::optional<Diagnostic> regionsWarning(const Scenario& scenario, const ForbiddenPlaces& places,
                                         const std::string& file);

/// Gives the judge the forbidden places of the scenario as planners find them, and the regions that its file states.
/// The scenario is read only if the question says that it forbids places. A warning is added where the file states
/// other regions.
Outcome addForbiddenPlaces(const std::string& scenarioFile, const StopToken& stop, check::Question& question);

}  // namespace glissade
