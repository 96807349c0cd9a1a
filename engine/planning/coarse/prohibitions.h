#pragma once

#include "engine/base/stop_token.h"
#include "engine/places/environment_model.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Forbidden places of a problem by its edits, which may change between calls. Not thread-safe.
class Prohibitions {
 public:
  /// The forbidden regions; null: nothing is forbidden. The places are those of the problem's knowledge. Where it has
  /// none they are computed here, once. Errors: an edit forbids a place that does not exist; those of
  /// buildEnvironment().
  Result<ForbiddenRegionsPtr> of(const Problem& problem, const StopToken& stop = {});

 private:
  Result<EnvironmentModelPtr> placesOf(const Problem& problem, const StopToken& stop);

  EnvironmentModelPtr found_;
  std::map<std::string, Attributes> foundWith_;  ///< the edits of bodies, which decide which bodies are static
};

/// The problem whose object keeps out of the places that its edits forbid. Errors as above.
Result<Problem> keepingOut(Problem problem, const StopToken& stop = {});

/// The first forbidden place on the way of the reference point; nothing where the way avoids all.
std::optional<std::string> firstForbidden(const std::vector<Pose>& path, const ForbiddenRegions& regions);

}  // namespace glissade
