#include "engine/import/step_fineness.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "engine/import/import_protocol.h"
#include "engine/import/step_deflection.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// Deflection in a close fit, in radii. OpenCASCADE comes to half of it: 40 triangles go around.
constexpr double kFine = 0.006;
/// Millimetres. A finer deflection costs triangles and tells nothing: parts are not made so exactly.
constexpr double kFinest = 0.01;
/// Millimetres by which the axes of a shaft and of its hole may be apart.
constexpr double kEccentric = 0.1;
/// Millimetres that a B-spline may be off a cylinder.
constexpr double kSameSurface = 1e-4;
/// Sine of the angle between them.
constexpr double kTilt = 1e-3;

double usualDeflectionOf(const StepSolid& solid) {
  Bnd_Box box;
  BRepBndLib::Add(solid.shape, box, false);
  const double diagonal = box.IsVoid() ? 0.0 : solid.placement.scale * std::sqrt(box.SquareExtent());
  return usualDeflection(protocol::kMillimetre * diagonal) / protocol::kMillimetre;
}

/// A cylindrical face where the assembly has it.
struct Cylinder {
  TopoDS_Face face;
  std::size_t solid = 0;
  double usual = 0.0;  ///< deflection of the solid
  gp_XYZ foot;         ///< the point of the axis that is nearest to the origin
  gp_XYZ axis;         ///< of unit length
  double radius = 0.0;
  double low = std::numeric_limits<double>::infinity();  ///< along the axis, from the foot
  double high = -std::numeric_limits<double>::infinity();
};

gp_XYZ mirroredIf(bool mirrored, gp_XYZ vector) {
  if (mirrored) vector.SetX(-vector.X());
  return vector;
}

struct SurfaceSample {
  gp_XYZ point;
  gp_XYZ normal;  ///< of unit length, or zero
};

std::vector<SurfaceSample> samplesOf(const BRepAdaptor_Surface& surface) {
  constexpr int kParts = 4;
  const auto between = [](double first, double last, int part) { return first + (last - first) * part / kParts; };
  std::vector<SurfaceSample> samples;
  for (int i = 0; i <= kParts; ++i) {
    for (int j = 0; j <= kParts; ++j) {
      gp_Pnt point;
      gp_Vec alongU;
      gp_Vec alongV;
      surface.D1(between(surface.FirstUParameter(), surface.LastUParameter(), i),
                 between(surface.FirstVParameter(), surface.LastVParameter(), j), point, alongU, alongV);
      const gp_XYZ normal = alongU.XYZ().Crossed(alongV.XYZ());
      const double length = normal.Modulus();
      samples.push_back({point.XYZ(), length > 0.0 ? normal / length : gp_XYZ()});
    }
  }
  return samples;
}

/// The cylinder with the normals of a surface, where the surface is one.
std::optional<gp_Cylinder> cylinderThrough(const std::vector<SurfaceSample>& samples) {
  const SurfaceSample& first = samples.front();
  const auto turned = [&](const SurfaceSample& sample) { return first.normal.Crossed(sample.normal); };
  const SurfaceSample& other =
      *std::max_element(samples.begin(), samples.end(), [&](const SurfaceSample& a, const SurfaceSample& b) {
        return turned(a).SquareModulus() < turned(b).SquareModulus();
      });
  const gp_XYZ axis = turned(other);
  if (axis.Modulus() < kTilt) return std::nullopt;
  // The two normals meet on the axis.
  const double signedRadius = (other.point - first.point).Crossed(other.normal).Dot(axis) / axis.SquareModulus();
  const double radius = std::abs(signedRadius);
  const gp_Ax3 frame(gp_Pnt(first.point + signedRadius * first.normal), gp_Dir(axis));
  const gp_Lin line(frame.Axis());
  const bool fits = std::all_of(samples.begin(), samples.end(), [&](const SurfaceSample& sample) {
    return std::abs(line.Distance(gp_Pnt(sample.point)) - radius) <= kSameSurface;
  });
  if (!fits) return std::nullopt;
  return gp_Cylinder(frame, radius);
}

/// Some programs write every surface as a B-spline.
std::optional<gp_Cylinder> cylinderOf(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  switch (surface.GetType()) {
    case GeomAbs_Cylinder: return surface.Cylinder();
    case GeomAbs_Plane:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus: return std::nullopt;
    default: return cylinderThrough(samplesOf(surface));
  }
}

Cylinder placed(const TopoDS_Face& face, const gp_Cylinder& surface, const StepPlacement& placement) {
  const auto inAssembly = [&](const gp_Pnt& point) {
    gp_XYZ moved = mirroredIf(placement.mirrored, placement.scale * point.XYZ());
    placement.rigid.Transforms(moved);
    return moved;
  };
  gp_XYZ axis = mirroredIf(placement.mirrored, surface.Axis().Direction().XYZ());
  axis.Multiply(placement.rigid.HVectorialPart());
  const gp_XYZ point = inAssembly(surface.Location());
  Cylinder cylinder;
  cylinder.face = face;
  cylinder.foot = point - point.Dot(axis) * axis;
  cylinder.axis = axis;
  cylinder.radius = placement.scale * surface.Radius();
  for (TopExp_Explorer at(face, TopAbs_VERTEX); at.More(); at.Next()) {
    const double along = inAssembly(BRep_Tool::Pnt(TopoDS::Vertex(at.Current()))).Dot(axis);
    cylinder.low = std::min(cylinder.low, along);
    cylinder.high = std::max(cylinder.high, along);
  }
  return cylinder;
}

std::vector<Cylinder> cylindersOf(const std::vector<StepSolid>& solids) {
  std::vector<Cylinder> cylinders;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const double usual = usualDeflectionOf(solids[i]);
    for (TopExp_Explorer at(solids[i].shape, TopAbs_FACE); at.More(); at.Next()) {
      const TopoDS_Face& face = TopoDS::Face(at.Current());
      const auto surface = cylinderOf(face);
      if (!surface) continue;
      cylinders.push_back(placed(face, *surface, solids[i].placement));
      cylinders.back().solid = i;
      cylinders.back().usual = usual;
    }
  }
  return cylinders;
}

/// One around the other, so closely that the deflection of their triangles is no smaller than the gap.
bool fitClosely(const Cylinder& a, const Cylinder& b) {
  if (a.solid == b.solid || std::abs(a.radius - b.radius) > a.usual + b.usual) return false;
  if (a.axis.Crossed(b.axis).Modulus() > kTilt || (a.foot - b.foot).Modulus() > kEccentric) return false;
  const bool alike = a.axis.Dot(b.axis) > 0.0;
  return a.low < (alike ? b.high : -b.low) && (alike ? b.low : -b.high) < a.high;
}

/// Cylinders by the place of their axes.
class AxisGrid {
 public:
  explicit AxisGrid(const std::vector<Cylinder>& cylinders) {
    for (std::size_t i = 0; i < cylinders.size(); ++i) cells_[cellOf(cylinders[i].foot)].push_back(i);
  }

  /// Calls `visit` with each cylinder whose foot may be within kEccentric of `foot`, until it returns true.
  template <class Visit>
  bool anyNear(const gp_XYZ& foot, const Visit& visit) const {
    const Cell centre = cellOf(foot);
    for (int i = 0; i < 27; ++i) {
      const auto found = cells_.find({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
      if (found != cells_.end() && std::any_of(found->second.begin(), found->second.end(), visit)) return true;
    }
    return false;
  }

 private:
  using Cell = std::array<long long, 3>;

  static Cell cellOf(const gp_XYZ& foot) {
    const auto index = [](double coordinate) { return std::llround(std::clamp(coordinate / kEccentric, -1e15, 1e15)); };
    return {index(foot.X()), index(foot.Y()), index(foot.Z())};
  }

  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

StepFineness::StepFineness(double deflection, const std::vector<StepSolid>& solids) : deflection_(deflection) {
  if (deflection_ > 0.0) return;
  const std::vector<Cylinder> cylinders = cylindersOf(solids);
  const AxisGrid grid(cylinders);
  for (const Cylinder& cylinder : cylinders) {
    if (fine_.IsBound(cylinder.face)) continue;
    const auto isClose = [&](std::size_t other) { return fitClosely(cylinder, cylinders[other]); };
    if (grid.anyNear(cylinder.foot, isClose)) fine_.Bind(cylinder.face, std::max(kFinest, kFine * cylinder.radius));
  }
}

Fineness StepFineness::of(const StepSolid& solid) const {
  Fineness fineness{deflection_ > 0.0 ? deflection_ : usualDeflectionOf(solid), {}};
  const BRep_Builder builder;
  for (TopExp_Explorer at(solid.shape, TopAbs_FACE); at.More(); at.Next()) {
    const double* deflection = fine_.Seek(at.Current());
    if (deflection == nullptr || *deflection >= fineness.deflection) continue;
    TopoDS_Compound& faces = fineness.fine[*deflection];
    if (faces.IsNull()) builder.MakeCompound(faces);
    builder.Add(faces, at.Current());
  }
  return fineness;
}

}  // namespace glissade
