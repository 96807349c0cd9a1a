#pragma once

#include "engine/places/rigid_body.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// Colours of the authors of a path, in the scene and in the bars of the panels; Okabe and Ito's hues.
inline Colour authorColour(Author author) {
  switch (author) {
    case Author::Computer: return {0.34, 0.71, 0.91};
    case Author::Operator: return {0.80, 0.47, 0.65};
    case Author::Contact: return {0.00, 0.62, 0.45};
  }
  return {0.5, 0.5, 0.5};
}

}  // namespace glissade
