#include "engine/import/step_stand_ins.h"

#include <algorithm>
#include <set>
#include <vector>

#include "engine/import/step_edited_text.h"
#include "engine/import/step_entities.h"
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

/// Handles a spherical face whose only boundary runs along a circle and back, which bounds a whole sphere. OpenCASCADE
/// 7.6 makes no triangles of it, so the boundary is replaced by a vertex, as other programs write a whole sphere.
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

using Id = std::uint64_t;

/// An item of a representation that OpenCASCADE ignores. It crashes on items that it does not know.
constexpr const char* kNothing = "CARTESIAN_POINT('',(0.,0.,0.))";

class StandIns {
 public:
  StandIns(const StepEntities& entities, const StatedShapes& stated)
      : entities_(entities), stated_(stated), edited_(entities) {}

  StepStandIns make() {
    emptyLists();
    makeSlitSpheresWhole(entities_, edited_);
    for (const StatedShape& item : stated_.items) {
      if (item.role == StepShapeRole::Boundary) continue;
      edited_.replace(item.entity, kNothing);
      if (item.role == StepShapeRole::Triangles && !item.isSecond) standInFor(item);
    }
    std::set<Id> adopted;
    for (const StatedShape& orphan : stated_.orphans) {
      if (orphan.role == StepShapeRole::Triangles) standInFor(orphan);
      const bool isRead = orphan.role == StepShapeRole::Boundary || orphan.role == StepShapeRole::Triangles;
      if (isRead && (orphan.representation == 0 || adopted.insert(orphan.representation).second)) adopt(orphan);
    }
    if (edited_.isEdited()) result_.text = edited_.text();
    return std::move(result_);
  }

 private:
  void emptyLists() {
    for (const StepEntities::Entity& entity : entities_.all()) {
      const std::string_view type = entities_.typeOf(entity);
      if (!holdsTessellation(type)) continue;
      const bool isList = type == "COORDINATES_LIST";
      edited_.replace(entity.id, isList ? "COORDINATES_LIST('',0,())" : kNothing);
    }
  }

  void standInFor(const StatedShape& item) {
    const auto [known, isNew] = result_.tessellations.try_emplace(item.entity);
    if (!isNew) return;
    known->second = tessellationOf(entities_, item.entity);
    if (known->second.fault.empty()) edited_.replace(item.entity, solid(nameOf(item.entity)));
    makeKnown(item.representation);
  }

  /// The quoted value of the item's name.
  std::string nameOf(Id item) const {
    const std::vector<StepRecord> records = entities_.recordsOf(item);
    for (const StepRecord& record : records) {
      if (records.size() > 1 && record.type != "REPRESENTATION_ITEM") continue;
      const auto values = stepValues(record.arguments);
      if (!values.empty() && values.front().front() == '\'') return std::string(values.front());
    }
    return "''";
  }

  /// Replaces an unknown representation by a SHAPE_REPRESENTATION with the same items and context.
  void makeKnown(Id representation) {
    const std::vector<StepRecord> records = entities_.recordsOf(representation);
    const bool isKnown = std::none_of(records.begin(), records.end(), [](const StepRecord& record) {
      return record.type.find("TESSELLATED_SHAPE_REPRESENTATION") != std::string_view::npos;
    });
    if (isKnown) return;
    for (const StepRecord& record : records) {
      const auto values = stepValues(record.arguments);
      if (values.size() < 3 || stepReference(values[2]) == 0) continue;
      edited_.replace(representation, "SHAPE_REPRESENTATION(" + std::string(values[0]) + "," + std::string(values[1]) +
                                          "," + std::string(values[2]) + ")");
    }
  }

  /// Adds a tetrahedron. All stand-ins share its faces.
  std::string solid(const std::string& name) {
    if (faces_.empty()) {
      const std::string o = point("0.,0.,0.");
      const std::string x = point("1000.,0.,0.");
      const std::string y = point("0.,1000.,0.");
      const std::string z = point("0.,0.,1000.");
      faces_ = face(o, y, x, "0.,0.,-1.", "1.,0.,0.") + "," + face(o, z, y, "-1.,0.,0.", "0.,1.,0.") + "," +
               face(o, x, z, "0.,-1.,0.", "1.,0.,0.") + "," + face(x, y, z, "1.,1.,1.", "1.,-1.,0.");
    }
    return "FACETED_BREP(" + name + "," + edited_.add("CLOSED_SHELL('',(" + faces_ + "))") + ")";
  }

  std::string point(const std::string& at) { return edited_.add("CARTESIAN_POINT('',(" + at + "))"); }

  std::string face(const std::string& a, const std::string& b, const std::string& c, const std::string& normal,
                   const std::string& along) {
    const std::string z = edited_.add("DIRECTION('',(" + normal + "))");
    const std::string x = edited_.add("DIRECTION('',(" + along + "))");
    const std::string plane =
        edited_.add("PLANE(''," + edited_.add("AXIS2_PLACEMENT_3D(''," + a + "," + z + "," + x + ")") + ")");
    const std::string loop = edited_.add("POLY_LOOP('',(" + a + "," + b + "," + c + "))");
    return edited_.add("FACE_SURFACE('',(" + edited_.add("FACE_OUTER_BOUND(''," + loop + ",.T.)") + ")," + plane +
                       ",.T.)");
  }

  void adopt(const StatedShape& orphan) {
    std::string representation = stepName(orphan.representation);
    if (orphan.representation == 0) {
      representation = edited_.add("SHAPE_REPRESENTATION('',(" + stepName(orphan.entity) + ")," + context() + ")");
    }
    if (application_.empty()) application_ = edited_.add("APPLICATION_CONTEXT('')");
    std::string name = nameOf(orphan.entity);
    if (name.find_first_not_of("' ") == std::string::npos) name = "'solid_" + std::to_string(orphan.entity) + "'";
    const std::string product = edited_.add("PRODUCT(" + name + "," + name + ",''," + "(" +
                                            edited_.add("PRODUCT_CONTEXT(''," + application_ + ",'')") + "))");
    const std::string definition =
        edited_.add("PRODUCT_DEFINITION('',''," + edited_.add("PRODUCT_DEFINITION_FORMATION('',''," + product + ")") +
                    "," + edited_.add("PRODUCT_DEFINITION_CONTEXT(''," + application_ + ",'')") + ")");
    edited_.add("SHAPE_DEFINITION_REPRESENTATION(" + edited_.add("PRODUCT_DEFINITION_SHAPE('',''," + definition + ")") +
                "," + representation + ")");
  }

  /// The first context of the file with units.
  std::string context() {
    for (const StepEntities::Entity& entity : entities_.all()) {
      for (const StepRecord& record : entities_.recordsOf(entity)) {
        if (record.type == "GLOBAL_UNIT_ASSIGNED_CONTEXT") return stepName(entity.id);
      }
    }
    return edited_.add("GEOMETRIC_REPRESENTATION_CONTEXT('','',3)");
  }

  const StepEntities& entities_;
  const StatedShapes& stated_;
  StepEditedText edited_;
  StepStandIns result_;
  std::string faces_;        ///< faces of all stand-ins
  std::string application_;  ///< context of the added products
};

}  // namespace

StepStandIns standInsFor(const StepEntities& entities, const StatedShapes& stated) {
  return StandIns(entities, stated).make();
}

}  // namespace glissade
