#pragma once

#include "engine/planning/path_examination.h"
#include "engine/scenario/kept_path.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What a kept path is in the scenario as it is now.
enum class KeptPathState {
  Unknown,     ///< not examined (yet), or the examination was stopped
  Holds,       ///< certified again
  Blocked,     ///< a body or a forbidden place is in the way, or the path leaves the workspace
  OtherEnds,   ///< it is free, but does not lead from the start to the goal
  OtherObject  ///< another object moves now
};

struct KeptPathProof {
  KeptPathState state = KeptPathState::Unknown;
  std::shared_ptr<const Path> path;  ///< with its certificate; null unless it is free
  std::string blockedBy;             ///< id of the body that blocks it first; empty where none is near
};

/// Certifies a kept path in the scenario, with the clearance that was required when it was kept, and out of what the
/// edits of its problem forbid. On any thread; takes its time, and ends as Unknown where it is stopped, or where an
/// edit forbids a place that is not there.
KeptPathProof proveAgain(const KeptPath& kept, const LoadedScenario& scenario, const WorkWatch& watch = {});

}  // namespace glissade
