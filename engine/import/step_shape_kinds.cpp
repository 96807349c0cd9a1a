#include "engine/import/step_shape_kinds.h"

#include <algorithm>
#include <array>

namespace glissade {
namespace {

using namespace std::string_view_literals;

constexpr std::array kBoundaries{
    "MANIFOLD_SOLID_BREP"sv,       "BREP_WITH_VOIDS"sv,          "FACETED_BREP"sv, "ADVANCED_FACE"sv,
    "SHELL_BASED_SURFACE_MODEL"sv, "FACE_BASED_SURFACE_MODEL"sv, "FACE_SURFACE"sv,
};

constexpr std::array kTriangulations{
    "TESSELLATED_SOLID"sv,         "TESSELLATED_SHELL"sv,        "TRIANGULATED_FACE"sv,
    "COMPLEX_TRIANGULATED_FACE"sv, "TRIANGULATED_SURFACE_SET"sv, "COMPLEX_TRIANGULATED_SURFACE_SET"sv,
};

/// Supertypes, which name no kind if an entity has another type.
constexpr std::array kSupertypes{
    "REPRESENTATION_ITEM"sv,
    "GEOMETRIC_REPRESENTATION_ITEM"sv,
    "TOPOLOGICAL_REPRESENTATION_ITEM"sv,
    "SOLID_MODEL"sv,
    "TESSELLATED_ITEM"sv,
    "TESSELLATED_STRUCTURED_ITEM"sv,
    "TESSELLATED_FACE"sv,
    "TESSELLATED_SURFACE_SET"sv,
    "REPOSITIONED_TESSELLATED_ITEM"sv,
    "BOUNDED_CURVE"sv,
    "CURVE"sv,
    "SURFACE"sv,
    "BOUNDED_SURFACE"sv,
    "REPRESENTATION"sv,
    "SHAPE_REPRESENTATION"sv,
};

/// Ends of the names of kinds without material.
constexpr std::array kWithoutMaterial{
    "PLACEMENT"sv,
    "AXIS2_PLACEMENT_2D"sv,
    "AXIS2_PLACEMENT_3D"sv,
    "POINT"sv,
    "VERTEX"sv,
    "EDGE"sv,
    "PATH"sv,
    "LOOP"sv,
    "WIRE"sv,
    "CURVE"sv,
    "CURVE_SET"sv,
    "POINT_SET"sv,
    "LINE"sv,
    "CIRCLE"sv,
    "ELLIPSE"sv,
    "HYPERBOLA"sv,
    "PARABOLA"sv,
    "CLOTHOID"sv,
    "WIREFRAME_MODEL"sv,
    "DIRECTION"sv,
    "VECTOR"sv,
    "OPERATOR_2D"sv,
    "OPERATOR_3D"sv,
    "_ITEM"sv,
    "TEXT"sv,
    "OCCURRENCE"sv,
    "CAMERA_MODEL_D3"sv,
    "PLANAR_BOX"sv,
    "PLANAR_EXTENT"sv,
    "SYMBOL"sv,
    "PLANE"sv,
    "CYLINDRICAL_SURFACE"sv,
    "CONICAL_SURFACE"sv,
    "CALLOUT"sv,
    "COORDINATES_LIST"sv,
    "EDGE_CURVE"sv,
};

/// Parts of the names of kinds for drawings.
constexpr std::array kOfDrawings{"TEXT"sv, "ANNOTATION"sv, "DRAUGHTING"sv, "LEADER"sv, "FILL_AREA"sv};

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N>& kinds, std::string_view kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool endsAsWithoutMaterial(std::string_view kind) {
  // These are an "item" by name, and a solid or a surface by meaning.
  if (kind == "TESSELLATED_ITEM" || kind == "REPOSITIONED_TESSELLATED_ITEM") return false;
  const bool isDrawn = std::any_of(kOfDrawings.begin(), kOfDrawings.end(),
                                   [&](std::string_view part) { return kind.find(part) != std::string_view::npos; });
  return isDrawn || std::any_of(kWithoutMaterial.begin(), kWithoutMaterial.end(),
                                [&](std::string_view end) { return kind.ends_with(end); });
}

/// The role of a set of points, curves and surfaces, or of tessellated items.
StepShapeRole roleOfSet(const StepEntities& entities, const std::vector<StepRecord>& records, StepShapeRole role) {
  for (const StepRecord& record : records) {
    for (const std::uint64_t element : stepReferencesIn(record.arguments)) {
      if (stepShapeRole(entities, entities.recordsOf(element)) != StepShapeRole::NoMaterial) return role;
    }
  }
  return StepShapeRole::NoMaterial;
}

}  // namespace

std::string stepKindOf(const std::vector<StepRecord>& records) {
  std::string_view kind;
  for (const StepRecord& record : records) {
    if (isOneOf(kBoundaries, record.type) || isOneOf(kTriangulations, record.type)) return std::string(record.type);
    if (kind.empty() || isOneOf(kSupertypes, kind)) kind = record.type;
  }
  return std::string(kind);
}

StepShapeRole stepShapeRole(const StepEntities& entities, const std::vector<StepRecord>& records) {
  const std::string kind = stepKindOf(records);
  if (kind == "GEOMETRIC_SET") return roleOfSet(entities, records, StepShapeRole::Boundary);
  if (kind == "TESSELLATED_GEOMETRIC_SET") return roleOfSet(entities, records, StepShapeRole::Triangles);
  if (isOneOf(kBoundaries, kind)) return StepShapeRole::Boundary;
  if (isOneOf(kTriangulations, kind)) return StepShapeRole::Triangles;
  return kind.empty() || endsAsWithoutMaterial(kind) ? StepShapeRole::NoMaterial : StepShapeRole::Unread;
}

bool holdsTessellation(std::string_view type) {
  return type == "COORDINATES_LIST" || type.ends_with("TRIANGULATED_FACE") ||
         type.ends_with("TRIANGULATED_SURFACE_SET");
}

}  // namespace glissade
