#pragma once

#include "engine/files/kept_path.h"
#include "engine/files/scenario.h"
#include "engine/planning/path_examination.h"

namespace glissade {

/// State of a kept path in the present scenario.
enum class KeptPathState {
  Unknown,     ///< not examined, or the examination was stopped
  Holds,       ///< certified again
  Blocked,     ///< a body or a forbidden place blocks the path, or it leaves the workspace
  OtherEnds,   ///< the path is free, but does not lead from the start to the goal
  OtherObject  ///< another object moves now
};

struct KeptPathProof {
  KeptPathState state = KeptPathState::Unknown;
  std::shared_ptr<const Path> path;  ///< the path with its certificate; null unless it is free
  BodyId blockedBy;                  ///< id of the first blocking body; empty where no body is near
};

/// Certifies a kept path in the scenario, with the required clearance stored in it and with the forbidden places of the
/// problem's edits. On any thread; may take long. The result is Unknown after a stop, or where an edit forbids a place
/// that does not exist.
KeptPathProof proveAgain(const KeptPath& kept, const LoadedScenario& scenario, const WorkWatch& watch = {});

}  // namespace glissade
