#include "engine/import/step_fineness.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
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

/// Deflection in a close fit, in radii. OpenCASCADE achieves half of it: 40 triangles around.
constexpr double kFine = 0.006;
/// Finest deflection, millimetres. Parts are not manufactured more exactly.
constexpr double kFinest = 0.01;
/// Largest distance of the axes of a shaft and its hole, millimetres.
constexpr double kEccentric = 0.1;
/// Largest distance of a B-spline from a cylinder, millimetres.
constexpr double kSameSurface = 1e-4;
/// Largest sine of the angle between the axes of a shaft and its hole.
constexpr double kTilt = 1e-3;
/// Least overlap along the axis, millimetres: cylinders that meet end to end are no fit.
constexpr double kOverlap = 0.01;

double diagonalOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

/// A cylindrical face, in the frame of its shape or of the assembly.
struct Cylinder {
  TopoDS_Face face;
  gp_XYZ point;  ///< on the axis; in the assembly, the point nearest to the origin
  gp_XYZ axis;   ///< unit
  double radius = 0.0;
  double low = std::numeric_limits<double>::infinity();  ///< range along the axis, from the point
  double high = -std::numeric_limits<double>::infinity();
  std::size_t solid = 0;
  double usual = 0.0;  ///< deflection of the solid
};

struct SurfaceSample {
  gp_XYZ point;
  gp_XYZ normal;  ///< unit, or zero
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

/// The cylinder with the normals of a surface; nothing if it is none.
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

/// The cylinder of a face; some programs write every surface as a B-spline.
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

std::vector<Cylinder> cylindersOf(const TopoDS_Shape& shape) {
  std::vector<Cylinder> cylinders;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
    const TopoDS_Face& face = TopoDS::Face(at.Current());
    const auto surface = cylinderOf(face);
    if (!surface) continue;
    Cylinder cylinder{face, surface->Location().XYZ(), surface->Axis().Direction().XYZ(), surface->Radius()};
    for (TopExp_Explorer end(face, TopAbs_VERTEX); end.More(); end.Next()) {
      const double along = (BRep_Tool::Pnt(TopoDS::Vertex(end.Current())).XYZ() - cylinder.point).Dot(cylinder.axis);
      cylinder.low = std::min(cylinder.low, along);
      cylinder.high = std::max(cylinder.high, along);
    }
    cylinders.push_back(cylinder);
  }
  return cylinders;
}

gp_XYZ mirroredIf(bool mirrored, gp_XYZ vector) {
  if (mirrored) vector.SetX(-vector.X());
  return vector;
}

Cylinder placed(Cylinder cylinder, const StepPlacement& placement) {
  cylinder.axis = mirroredIf(placement.mirrored, cylinder.axis);
  cylinder.axis.Multiply(placement.rigid.HVectorialPart());
  cylinder.point = mirroredIf(placement.mirrored, placement.scale * cylinder.point);
  placement.rigid.Transforms(cylinder.point);
  const double along = cylinder.point.Dot(cylinder.axis);
  cylinder.point -= along * cylinder.axis;
  cylinder.radius *= placement.scale;
  cylinder.low = along + placement.scale * cylinder.low;
  cylinder.high = along + placement.scale * cylinder.high;
  return cylinder;
}

/// The cylinders in the assembly. Each shape is examined once, whatever the number of its solids.
std::vector<Cylinder> cylindersOf(const std::vector<StepSolid>& solids) {
  NCollection_DataMap<TopoDS_Shape, std::vector<Cylinder>, TopTools_ShapeMapHasher> ofShapes;
  std::vector<Cylinder> cylinders;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (!ofShapes.IsBound(solids[i].shape)) ofShapes.Bind(solids[i].shape, cylindersOf(solids[i].shape));
    for (const Cylinder& own : ofShapes.Find(solids[i].shape)) {
      cylinders.push_back(placed(own, solids[i].placement));
      cylinders.back().solid = i;
    }
  }
  return cylinders;
}

/// True if one is around the other with a gap that is no larger than the deflection of their triangles.
bool fitClosely(const Cylinder& a, const Cylinder& b) {
  if (a.solid == b.solid || std::abs(a.radius - b.radius) > a.usual + b.usual) return false;
  if (a.axis.Crossed(b.axis).Modulus() > kTilt || (a.point - b.point).Modulus() > kEccentric) return false;
  const bool alike = a.axis.Dot(b.axis) > 0.0;
  const double low = std::max(a.low, alike ? b.low : -b.high);
  const double high = std::min(a.high, alike ? b.high : -b.low);
  return high - low > kOverlap;
}

/// Cylinders, hashed by the points of their axes.
class AxisGrid {
 public:
  explicit AxisGrid(const std::vector<Cylinder>& cylinders) {
    for (std::size_t i = 0; i < cylinders.size(); ++i) cells_[cellOf(cylinders[i].point)].push_back(i);
  }

  /// Calls `visit` with each cylinder whose point may be within kEccentric of `point`, until it returns true.
  template <class Visit>
  bool anyNear(const gp_XYZ& point, const Visit& visit) const {
    const Cell centre = cellOf(point);
    for (int i = 0; i < 27; ++i) {
      const auto found = cells_.find({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
      if (found != cells_.end() && std::any_of(found->second.begin(), found->second.end(), visit)) return true;
    }
    return false;
  }

 private:
  using Cell = std::array<long long, 3>;

  static Cell cellOf(const gp_XYZ& point) {
    const auto index = [](double coordinate) { return std::llround(std::clamp(coordinate / kEccentric, -1e15, 1e15)); };
    return {index(point.X()), index(point.Y()), index(point.Z())};
  }

  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

StepFineness::StepFineness(double deflection, const std::vector<StepSolid>& solids) : deflection_(deflection) {
  if (deflection_ > 0.0) return;
  for (const StepSolid& solid : solids) {
    if (!diagonals_.IsBound(solid.shape)) diagonals_.Bind(solid.shape, diagonalOf(solid.shape));
  }
  std::vector<Cylinder> cylinders = cylindersOf(solids);
  for (Cylinder& cylinder : cylinders) cylinder.usual = deflectionOf(solids[cylinder.solid]);
  const AxisGrid grid(cylinders);
  for (const Cylinder& cylinder : cylinders) {
    if (fine_.IsBound(cylinder.face)) continue;
    const auto isClose = [&](std::size_t other) { return fitClosely(cylinder, cylinders[other]); };
    if (grid.anyNear(cylinder.point, isClose)) fine_.Bind(cylinder.face, std::max(kFinest, kFine * cylinder.radius));
  }
}

double StepFineness::deflectionOf(const StepSolid& solid) const {
  if (deflection_ > 0.0) return deflection_;
  const double diagonal = protocol::kMillimetre * solid.placement.scale * diagonals_.Find(solid.shape);
  return usualDeflection(diagonal) / protocol::kMillimetre;
}

Fineness StepFineness::of(const StepSolid& solid) const {
  Fineness fineness{deflectionOf(solid), {}};
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
