#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/import/step_entities.h"

namespace glissade {

/// The use of an item of a shape representation.
enum class StepShapeRole : std::uint8_t {
  NoMaterial,  ///< placements, points, curves, texts, unbounded planes: they are no obstacles
  Boundary,    ///< solids by boundaries, and surfaces: OpenCASCADE makes them
  Triangles,   ///< tessellations: this project makes them (step_tessellated.h)
  Unread,      ///< every other kind: solids by volumes and operations, sweeps, unknown kinds
};

/// The kind of an entity for people: the most specific one of several types.
std::string stepKindOf(const std::vector<StepRecord>& records);

/// The role by ISO 10303-42, -43, -45, -511, -512, -514, -1804. An unknown kind counts as possible material.
StepShapeRole stepShapeRole(const StepEntities& entities, const std::vector<StepRecord>& records);

/// True if an entity of this type contains lists of coordinates or triangles, which may be long.
bool holdsTessellation(std::string_view type);

}  // namespace glissade
