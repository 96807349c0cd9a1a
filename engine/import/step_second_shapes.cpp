#include "engine/import/step_second_shapes.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <algorithm>
#include <cmath>

#include "engine/import/import_protocol.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

Bnd_Box boxOfTriangles(const StepTessellation& triangles, const gp_Trsf& placement) {
  Bnd_Box box;
  for (std::size_t i = 0; i < triangles.vertices.size(); i += 3) {
    box.Add(gp_Pnt(triangles.vertices[i], triangles.vertices[i + 1], triangles.vertices[i + 2]).Transformed(placement));
  }
  return box;
}

/// Tolerance: a fiftieth of the size, because triangles are inside of round surfaces.
bool isSameBox(const Bnd_Box& a, const Bnd_Box& b) {
  constexpr double kShare = 0.02;
  if (a.IsVoid() || b.IsVoid()) return false;
  const double size = a.CornerMin().Distance(a.CornerMax());
  const auto near = [&](const gp_Pnt& p, const gp_Pnt& q) {
    return std::abs(p.X() - q.X()) <= kShare * size && std::abs(p.Y() - q.Y()) <= kShare * size &&
           std::abs(p.Z() - q.Z()) <= kShare * size;
  };
  return near(a.CornerMin(), b.CornerMin()) && near(a.CornerMax(), b.CornerMax());
}

std::string parentOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

/// The boundaries of the product beside the triangles, in this use of the product.
std::vector<const StepSolid*> boundariesBeside(const StepSolid& triangles, const StatedShape& item,
                                               const std::vector<StepSolid>& solids, const StandInShapes& standIns) {
  std::vector<const StepSolid*> found;
  for (const StepSolid& solid : solids) {
    const bool isBeside = parentOf(solid.path) == parentOf(triangles.path);
    if (isBeside && standIns.isBoundaryOf(item.product, solid.shape)) found.push_back(&solid);
  }
  return found;
}

bool isSecond(const StepSolid& triangles, const std::vector<const StepSolid*>& boundaries,
              const StandInShapes& standIns) {
  const Bnd_Box box = boxOfTriangles(*standIns.of(triangles.shape), triangles.placement.rigid);
  Bnd_Box all;
  bool isOfOne = false;
  for (const StepSolid* boundary : boundaries) {
    Bnd_Box own;
    BRepBndLib::AddOptimal(boundary->shape.Located(TopLoc_Location(boundary->placement.rigid)), own, false, false);
    all.Add(own);
    isOfOne = isOfOne || isSameBox(box, own);
  }
  return isOfOne || isSameBox(box, all);
}

/// Renames a solid that is alone again to the name of its product.
void shortenAlone(const std::string& parent, std::vector<StepSolid>& solids) {
  const auto isBelow = [&](const StepSolid& solid) { return parentOf(solid.path) == parent; };
  const auto only = std::find_if(solids.begin(), solids.end(), isBelow);
  if (parent.empty() || only == solids.end() || std::count_if(solids.begin(), solids.end(), isBelow) != 1) return;
  only->path = parent;
  only->names.pop_back();
  only->formerPath.clear();
  only->isOneOfSeveral = false;
}

}  // namespace

SecondShapes takeOutSecondShapes(std::vector<StepSolid>& solids, const StandInShapes& standIns) {
  SecondShapes second;
  std::vector<std::string> out;
  for (const StepSolid& solid : solids) {
    const StatedShape* item = standIns.maybeSecond(solid.shape);
    if (item == nullptr || !isSecond(solid, boundariesBeside(solid, *item, solids, standIns), standIns)) continue;
    out.push_back(solid.path);
    if (!second.items.insert(item->entity).second) continue;
    second.notes.push_back(
        stepShapeNote(import_protocol::kSecondLine, *item,
                      GLISSADE_TEXT("it is taken for a second representation of a solid of its size and is left out")));
  }
  std::erase_if(solids,
                [&](const StepSolid& solid) { return std::find(out.begin(), out.end(), solid.path) != out.end(); });
  for (const std::string& path : out) shortenAlone(parentOf(path), solids);
  return second;
}

}  // namespace glissade
