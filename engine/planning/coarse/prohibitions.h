#pragma once

#include "engine/base/stop_token.h"
#include "engine/environment/environment_model.h"
#include "engine/planning/problem.h"

namespace glissade {

/// What the edits of a problem forbid, asked again and again while they change. Not for several threads at once.
class Prohibitions {
 public:
  /// Null: nothing is forbidden. The places are those of the problem's knowledge; where it has none they are found
  /// here, once. Errors: an edit forbids a place that is not there; those of buildEnvironment().
  Result<ForbiddenRegionsPtr> of(const Problem& problem, const StopToken& stop = {});

 private:
  Result<EnvironmentModelPtr> placesOf(const Problem& problem, const StopToken& stop);

  EnvironmentModelPtr found_;
  std::map<std::string, Attributes> foundWith_;  ///< the edits of bodies, which decide what is static
};

/// The problem whose object keeps out of what its edits forbid. Errors as above.
Result<Problem> keepingOut(Problem problem, const StopToken& stop = {});

/// The first place that is forbidden on the way of the reference point; nothing where it keeps out of all.
std::optional<std::string> firstForbidden(const std::vector<Pose>& path, const ForbiddenRegions& regions);

}  // namespace glissade
