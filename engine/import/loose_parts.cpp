#include "engine/import/loose_parts.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>

#include "engine/base/printable_text.h"
#include "engine/import/import_protocol.h"
#include "engine/import/import_refusal.h"
#include "engine/import/node_steps.h"
#include "engine/import/step_shape_notes.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

bool isCompound(const TopoDS_Shape& shape) { return shape.ShapeType() == TopAbs_COMPOUND; }

bool has(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) { return TopExp_Explorer(shape, kind).More(); }

/// False for a loose face.
bool isNode(const TopoDS_Shape& shape) { return isCompound(shape) || has(shape, TopAbs_SOLID); }

bool isAssembly(const TopoDS_Shape& shape) {
  if (!isCompound(shape)) return false;
  for (TopoDS_Iterator child(shape, false, false); child.More(); child.Next()) {
    if (isNode(child.Value())) return true;
  }
  return false;
}

class LooseParts {
 public:
  LooseParts(double tolerance, const ShapeName& nameOf) : tolerance_(tolerance), nameOf_(nameOf) {
    assembly_.isSewn = true;
  }

  StepAssembly partsOf(const std::vector<TopoDS_Shape>& roots) {
    addBelow({}, roots);
    return std::move(assembly_);
  }

 private:
  struct Place {
    std::string path;
    std::vector<NodeNames> names;
    TopLoc_Location location;
    int depth = 0;
  };

  /// Adds the children; faces beside solids and compounds are parts together.
  void addBelow(const Place& place, const std::vector<TopoDS_Shape>& children) {
    if (place.depth > protocol::kDeepestAssembly) {
      throw ImportRefusal{GLISSADE_TEXT("its groups are nested too deeply")};
    }
    if (children.size() == 1 && isNode(children.front())) {
      addNode(place, children.front());
      return;
    }
    std::vector<TopoDS_Shape> nodes;
    TopoDS_Compound faces;
    BRep_Builder builder;
    builder.MakeCompound(faces);
    for (const TopoDS_Shape& child : children) {
      if (isNode(child)) {
        nodes.push_back(child);
      } else {
        builder.Add(faces, child);
      }
    }
    noteCurves(faces, place);
    const std::size_t groups = nodes.size();
    for (const TopoDS_Shape& part : sewn(faces)) nodes.push_back(part);
    const std::vector<NodeStep> steps = stepsOfNodes(nodes, groups);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const bool isOnly = nodes.size() == 1 && place.path.empty();
      const Place at = isOnly ? place : below(place, steps[i]);
      if (i < groups) {
        addNode(at, nodes[i]);
      } else {
        addSolid(at, nodes[i], false);
      }
    }
  }

  void addChildrenOf(const Place& place, const TopoDS_Shape& assembly) {
    if (++occurrences_ > protocol::kMostOccurrences) {
      throw ImportRefusal{GLISSADE_TEXT("it has too many groups and parts")};
    }
    Place inside = place;
    inside.location = place.location * assembly.Location();
    ++inside.depth;
    std::vector<TopoDS_Shape> children;
    for (TopoDS_Iterator child(assembly, false, false); child.More(); child.Next()) children.push_back(child.Value());
    addBelow(inside, children);
  }

  /// Compounds before `firstSewn` are groups; the others are faces that are open after sewing.
  std::vector<NodeStep> stepsOfNodes(const std::vector<TopoDS_Shape>& nodes, std::size_t firstSewn) const {
    std::vector<NodeNames> names;
    std::vector<std::string> former;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const char* usual = !isCompound(nodes[i]) ? "solid" : i < firstSewn ? "part" : "surfaces";
      names.push_back({printableLine(nameOf_(nodes[i]))});
      if (asStep(names.back().product).empty()) names.back().product = usual;
      former.push_back(names.back().product);
    }
    return stepsFor(names, former);
  }

  static Place below(const Place& place, const NodeStep& step) {
    Place inside = place;
    inside.path = joinedPath(place.path, step.step);
    inside.names.push_back(step.names);
    return inside;
  }

  void addNode(const Place& place, const TopoDS_Shape& node) {
    if (isAssembly(node)) {
      addChildrenOf(place, node);
      return;
    }
    noteCurves(node, place);
    Place inside = place;
    inside.location = place.location * node.Location();
    const TopoDS_Shape atOrigin = node.Located(TopLoc_Location());
    std::vector<TopoDS_Shape> shapes;
    if (isCompound(node)) shapes = sewn(atOrigin);
    for (TopExp_Explorer solid(atOrigin, TopAbs_SOLID); solid.More(); solid.Next()) shapes.push_back(solid.Current());
    const std::vector<NodeStep> steps = stepsOfNodes(shapes, 0);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      addSolid(shapes.size() > 1 ? below(inside, steps[i]) : inside, shapes[i], shapes.size() > 1);
    }
  }

  void noteCurves(const TopoDS_Shape& shape, const Place& place) {
    for (StepNote& note : curveNotes(shape, place.path)) assembly_.notes.push_back(std::move(note));
  }

  void addSolid(const Place& place, const TopoDS_Shape& shape, bool isOneOfSeveral) {
    if (assembly_.solids.size() == protocol::kMostParts) {
      throw ImportRefusal{{GLISSADE_TEXT("it has more than %1 parts"), {protocol::kMostParts}}};
    }
    MirroredInstances none;
    const StepPlacement placement = none.placementOf(place.location * shape.Location(), place.path);
    assembly_.solids.push_back({place.path, place.names, shape.Located(TopLoc_Location()), placement, std::nullopt});
    assembly_.solids.back().isOneOfSeveral = isOneOfSeveral && !place.path.empty();
  }

  /// Solids of the closed shells, and one compound of the other faces.
  std::vector<TopoDS_Shape> sewn(const TopoDS_Shape& faces) {
    std::vector<TopoDS_Shape> parts;
    if (!has(faces, TopAbs_FACE)) return parts;
    BRepBuilderAPI_Sewing sewing(tolerance_);
    for (TopExp_Explorer face(faces, TopAbs_FACE); face.More(); face.Next()) sewing.Add(face.Current());
    sewing.Perform();
    noteDeleted(sewing.NbDeletedFaces());
    const TopoDS_Shape& whole = sewing.SewedShape();
    BRep_Builder builder;
    TopoDS_Compound open;
    builder.MakeCompound(open);
    for (TopExp_Explorer shell(whole, TopAbs_SHELL); shell.More(); shell.Next()) {
      TopoDS_Solid solid;
      builder.MakeSolid(solid);
      builder.Add(solid, shell.Current());
      if (BRep_Tool::IsClosed(shell.Current()) && BRepLib::OrientClosedSolid(solid)) {
        parts.push_back(solid);
      } else {
        builder.Add(open, shell.Current());
      }
    }
    for (TopExp_Explorer face(whole, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next()) {
      builder.Add(open, face.Current());
    }
    if (has(open, TopAbs_FACE)) parts.push_back(open);
    return parts;
  }

  void noteDeleted(int faces) {
    if (faces <= 0) return;
    assembly_.notes.push_back(
        {protocol::kLossLine,
         "",
         {GLISSADE_TEXT("%1 {1|face is|faces are} smaller than the gaps between faces"), {faces}}});
  }

  double tolerance_;
  const ShapeName& nameOf_;
  StepAssembly assembly_;
  std::size_t occurrences_ = 0;
};

}  // namespace

StepAssembly loosePartsOf(const std::vector<TopoDS_Shape>& roots, double tolerance, const ShapeName& nameOf) {
  constexpr double kMostShare = 1e-4;  // share of the diagonal; a larger one would join separate faces
  Bnd_Box box;
  for (const TopoDS_Shape& root : roots) BRepBndLib::Add(root, box, false);
  const double diagonal = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
  return LooseParts(std::min(tolerance, kMostShare * diagonal), nameOf).partsOf(roots);
}

}  // namespace glissade
