#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/import/step_entities.h"

namespace glissade {

/// The use that is made of an item of a shape representation.
enum class StepShapeRole : std::uint8_t {
  NoMaterial,  ///< placements, points, curves, texts, unbounded planes: they are in nothing's way
  Boundary,    ///< solids by their boundaries, and surfaces: OpenCASCADE makes them
  Triangles,   ///< tessellated: this project makes them (step_tessellated.h)
  Unread,      ///< every other kind: solids by volumes and their operations, sweeps, kinds that are not known
};

/// The kind of an entity as people name it: of several types the one that says most.
std::string stepKindOf(const std::vector<StepRecord>& records);

/// ISO 10303-42, -43, -45, -511, -512, -514, -1804. A kind that is not known may be material.
StepShapeRole stepShapeRole(const StepEntities& entities, const std::vector<StepRecord>& records);

/// An entity of this type holds lists of coordinates or triangles, as long as there are any.
bool holdsTessellation(std::string_view type);

}  // namespace glissade
