#pragma once

#include "engine/base/stop_token.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What the edits of `content` forbid among the bodies that are loaded, as its file states it. The places are found
/// anew, so that the boxes are those of the present arrangement. Errors: those of Prohibitions::of().
Result<ForbiddenPlaces> forbiddenPlacesOf(const LoadedScenario& loaded, const Scenario& content,
                                          const StopToken& stop = {});

/// Says that the file does not state these places; nothing where it does.
std::optional<Diagnostic> regionsWarning(const Scenario& scenario, const ForbiddenPlaces& places,
                                         const std::string& file);

}  // namespace glissade
