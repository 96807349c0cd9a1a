#include "engine/import/step_whole_spheres.h"

#include "engine/import/step_shape_kinds.h"

namespace glissade {
namespace {

using Values = std::vector<std::string_view>;

/// The values of an entity with this type only; empty for another entity.
Values valuesOfOne(const StepEntities& entities, std::string_view reference, std::string_view type) {
  const std::vector<StepRecord> records = entities.recordsOf(stepReference(reference));
  return records.size() == 1 && records.front().type == type ? stepValues(records.front().arguments) : Values();
}

/// An ORIENTED_EDGE: its edge, and whether it has the edge's direction.
struct OrientedEdge {
  std::string_view edge;
  std::string_view along;
};

OrientedEdge orientedEdge(const StepEntities& entities, std::string_view reference) {
  const Values values = valuesOfOne(entities, reference, "ORIENTED_EDGE");
  return values.size() == 5 ? OrientedEdge{values[3], values[4]} : OrientedEdge{};
}

/// The vertex of a loop that runs along one closed edge and back; empty for another loop.
std::string_view vertexOfSlit(const StepEntities& entities, std::string_view loop) {
  const Values values = valuesOfOne(entities, loop, "EDGE_LOOP");
  const Values edges = values.size() == 2 ? stepList(values[1]) : Values();
  if (edges.size() != 2) return {};
  const OrientedEdge there = orientedEdge(entities, edges[0]);
  const OrientedEdge back = orientedEdge(entities, edges[1]);
  if (there.edge.empty() || there.edge != back.edge || there.along == back.along) return {};
  const Values edge = valuesOfOne(entities, there.edge, "EDGE_CURVE");
  return edge.size() == 5 && edge[1] == edge[2] ? edge[1] : std::string_view();
}

}  // namespace

void makeSlitSpheresWhole(const StepEntities& entities, StepEditedText& edited) {
  for (const StepEntities::Entity& entity : entities.all()) {
    const std::string_view type = entities.typeOf(entity);
    if (type != "ADVANCED_FACE" && type != "FACE_SURFACE") continue;
    const std::vector<StepRecord> records = entities.recordsOf(entity);
    if (records.size() != 1) continue;
    const Values face = stepValues(records.front().arguments);
    const Values bounds = face.size() == 4 ? stepList(face[1]) : Values();
    if (bounds.size() != 1 || valuesOfOne(entities, face[2], "SPHERICAL_SURFACE").empty()) continue;
    Values bound = valuesOfOne(entities, bounds.front(), "FACE_OUTER_BOUND");
    if (bound.empty()) bound = valuesOfOne(entities, bounds.front(), "FACE_BOUND");
    const std::string_view vertex = bound.size() == 3 ? vertexOfSlit(entities, bound[1]) : std::string_view();
    if (!vertex.empty()) edited.replace(stepReference(bound[1]), "VERTEX_LOOP(''," + std::string(vertex) + ")");
  }
}

}  // namespace glissade
