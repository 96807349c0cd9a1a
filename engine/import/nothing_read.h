#pragma once

#include <algorithm>

#include "engine/base/message.h"
#include "engine/import/import_protocol.h"
#include "engine/import/step_note.h"

namespace glissade {

/// The reason why a file gives no body: "it holds neither a solid nor a face: #12 CSG_SOLID: its kind is not read",
/// with the first missing shape of the notes.
inline Message nothingRead(const StepNotes& notes) {
  const auto missing = std::find_if(notes.begin(), notes.end(),
                                    [](const StepNote& note) { return note.kind == import_protocol::kMissingLine; });
  if (missing == notes.end()) return GLISSADE_TEXT("it holds neither a solid nor a face");
  return {GLISSADE_TEXT("it holds neither a solid nor a face: %1 %2: %3"),
          {missing->entity, missing->shapeKind, missing->text}};
}

}  // namespace glissade
