#include "engine/import/shape_overlaps.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <limits>
#include <optional>

namespace glissade {
namespace {

/// The transformation from the origin of a shape to its place.
gp_Trsf transformationOf(const StepPlacement& placement) {
  gp_Trsf whole = placement.rigid;
  gp_Trsf scaled;
  scaled.SetScale(gp_Pnt(0.0, 0.0, 0.0), placement.scale);
  whole.Multiply(scaled);
  if (!placement.mirrored) return whole;
  gp_Trsf mirrored;
  mirrored.SetMirror(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(1.0, 0.0, 0.0)));
  whole.Multiply(mirrored);
  return whole;
}

bool isBelow(const std::string& path, const std::string& node) {
  return node.empty() || path == node ||
         (path.size() > node.size() && path.compare(0, node.size(), node) == 0 && path[node.size()] == '/');
}

std::vector<TopoDS_Solid> solidsOf(const StepAssembly& assembly, const std::string& part) {
  std::vector<TopoDS_Solid> solids;
  for (const StepSolid& each : assembly.solids) {
    if (!isBelow(each.path, part)) continue;
    const gp_Trsf transformation = transformationOf(each.placement);
    for (TopExp_Explorer explorer(each.shape, TopAbs_SOLID); explorer.More(); explorer.Next()) {
      // A copy is made, because a location cannot reverse or scale a shape.
      solids.push_back(TopoDS::Solid(BRepBuilderAPI_Transform(explorer.Current(), transformation, true).Shape()));
    }
  }
  return solids;
}

bool areApart(const TopoDS_Solid& one, const TopoDS_Solid& other) {
  Bnd_Box a;
  Bnd_Box b;
  BRepBndLib::Add(one, a);
  BRepBndLib::Add(other, b);
  return a.IsOut(b);
}

std::optional<double> commonVolumeOf(const TopoDS_Solid& one, const TopoDS_Solid& other) {
  if (areApart(one, other)) return 0.0;
  BRepAlgoAPI_Common common(one, other);
  if (!common.IsDone() || common.HasErrors()) return std::nullopt;
  GProp_GProps properties;
  BRepGProp::VolumeProperties(common.Shape(), properties);
  return properties.Mass();
}

}  // namespace

double commonVolume(const StepAssembly& assembly, const std::string& a, const std::string& b) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  try {
    const std::vector<TopoDS_Solid> others = solidsOf(assembly, b);
    const std::vector<TopoDS_Solid> own = solidsOf(assembly, a);
    if (own.empty() || others.empty()) return kUnknown;
    double sum = 0.0;
    for (const TopoDS_Solid& one : own) {
      for (const TopoDS_Solid& other : others) {
        const auto volume = commonVolumeOf(one, other);
        if (!volume) return kUnknown;
        sum += *volume;
      }
    }
    return sum;
  } catch (const Standard_Failure&) {
    return kUnknown;
  }
}

}  // namespace glissade
