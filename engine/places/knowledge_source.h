#pragma once

#include <memory>

#include "engine/places/attribute.h"
#include "engine/places/environment_model.h"

namespace glissade {

/// Inputs of a scene's knowledge besides the bodies. The same inputs give the same knowledge, so that a record of a run
/// stores only these.
struct KnowledgeSource {
  EnvironmentOptions options;
  std::shared_ptr<const SemanticEdits> edits;  ///< edits, of which the mobility of bodies matters; null: none
  double requiredClearance = 0.0;              ///< required clearance, metres
};

}  // namespace glissade
