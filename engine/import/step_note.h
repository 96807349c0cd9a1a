#pragma once

#include <string>
#include <vector>

#include "engine/base/diagnostic.h"

namespace glissade {

/// A note of the STEP process for its parent: see import_protocol.h.
struct StepNote {
  char kind;                ///< import_protocol::kLossLine, ...
  Location place;           ///< empty for a missing shape
  Message text;             ///< for a missing shape, its reason
  std::string product{};    ///< of a missing shape
  std::string entity{};     ///< of a missing shape
  std::string shapeKind{};  ///< of a missing shape
};
using StepNotes = std::vector<StepNote>;

}  // namespace glissade
