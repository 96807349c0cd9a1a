#pragma once

#include <memory>

#include "engine/environment/attribute.h"
#include "engine/environment/environment_model.h"

namespace glissade {

/// What a scene's knowledge was built from, besides the bodies: building again from the same gives the
/// same, so a record of a run needs no more of it.
struct KnowledgeSource {
  EnvironmentOptions options;
  std::shared_ptr<const SemanticEdits> edits;  ///< their mobility of bodies matters; null: none
  double requiredClearance = 0.0;              ///< metres
};

}  // namespace glissade
