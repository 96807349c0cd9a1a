#include "engine/import/step_tessellation.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>

#include "engine/import/step_faces.h"
#include "engine/import/step_measures.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// OpenCASCADE exceeds the requested deflection by up to 1.6 times on spheres.
constexpr double kAsked = 0.5;

protocol::Face recordOf(const SurfaceFace& face, int triangles) {
  protocol::Face record;
  record.kind = static_cast<std::uint32_t>(face.kind);
  record.triangles = static_cast<std::uint32_t>(triangles);
  for (int i = 0; i < 3; ++i) {
    record.point[i] = face.point[i];
    record.axis[i] = face.axis[i];
  }
  record.radius = face.radius;
  record.second = face.second;
  record.deflection = face.deflection;
  return record;
}

void addFace(const TopoDS_Face& face, const std::string& entity, StepTriangles& triangles) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || mesh->NbTriangles() == 0) {
    ++triangles.record.facesWithoutMesh;
    return;
  }
  const auto base = static_cast<std::uint32_t>(triangles.vertices.size() / 3);
  const gp_Trsf placement = location.Transformation();
  for (int i = 1; i <= mesh->NbNodes(); ++i) {
    const gp_Pnt p = mesh->Node(i).Transformed(placement);
    triangles.vertices.insert(triangles.vertices.end(), {p.X(), p.Y(), p.Z()});
  }
  const bool reversed = (face.Orientation() == TopAbs_REVERSED) != placement.IsNegative();
  for (int i = 1; i <= mesh->NbTriangles(); ++i) {
    int a = 0;
    int b = 0;
    int c = 0;
    mesh->Triangle(i).Get(a, b, c);
    if (reversed) std::swap(b, c);
    for (const int corner : {a, b, c}) triangles.indices.push_back(base + static_cast<std::uint32_t>(corner - 1));
  }
  triangles.faces.push_back(recordOf(measuredFace(face, mesh, placement), mesh->NbTriangles()));
  triangles.entities.push_back(entity);
}

/// Slow; needed only for parts with healed faces. The volume of a face whose boundary encloses nothing is not known.
void compareVolumes(const TopoDS_Shape& shape, StepTriangles& triangles) {
  constexpr double kAccuracy = 1e-4;
  if (triangles.healed.empty() || shape.ShapeType() != TopAbs_SOLID) return;
  const bool isKnown = std::none_of(triangles.healed.begin(), triangles.healed.end(),
                                    [](const HealedFace& face) { return face.meshing == FaceMeshing::WithOther; });
  if (!isKnown) return;
  const TriangleMeasures measures = measuresOf(triangles);
  GProp_GProps exact;
  BRepGProp::VolumeProperties(shape, exact, kAccuracy);
  triangles.volume = measures.volume;
  triangles.exactVolume = exact.Mass();
  triangles.volumeDiffers =
      !(std::abs(measures.volume - exact.Mass()) <= measures.uncertainty() + 2.0 * kAccuracy * std::abs(exact.Mass()));
}

void resize(protocol::Face& face, double scale, bool mirrored) {
  for (double& coordinate : face.point) coordinate *= scale;
  face.radius *= scale;
  face.deflection *= scale;
  if (face.kind == static_cast<std::uint32_t>(SurfaceFace::Kind::Torus)) face.second *= scale;
  if (!mirrored) return;
  face.point[0] = -face.point[0];
  face.axis[0] = -face.axis[0];
}

/// Scales every vertex alike, so that vertices that faces share stay equal.
void resize(StepTriangles& triangles, double scale, bool mirrored) {
  for (std::size_t i = 0; i < triangles.vertices.size(); ++i) {
    triangles.vertices[i] *= mirrored && i % 3 == 0 ? -scale : scale;
  }
  for (std::size_t i = 0; mirrored && i < triangles.indices.size(); i += 3) {
    std::swap(triangles.indices[i + 1], triangles.indices[i + 2]);
  }
  for (protocol::Face& face : triangles.faces) resize(face, scale, mirrored);
}

void count(StepTriangles& triangles) {
  triangles.record.vertices = static_cast<std::uint32_t>(triangles.vertices.size() / 3);
  triangles.record.triangles = static_cast<std::uint32_t>(triangles.indices.size() / 3);
  triangles.record.faces = static_cast<std::uint32_t>(triangles.faces.size());
}

Fineness scaled(const Fineness& fineness, double factor) {
  Fineness result{factor * fineness.deflection, {}};
  for (const auto& [deflection, faces] : fineness.fine) result.fine[factor * deflection] = faces;
  return result;
}

}  // namespace

StepTriangles tessellate(const TopoDS_Shape& shape, const Fineness& fineness, const FaceEntities& entities,
                         double scale, bool mirrored) {
  StepTriangles triangles;
  triangles.healed = meshAndHeal(shape, scaled(fineness, kAsked / scale));
  const auto isInOther = [&](const TopoDS_Shape& face) {
    return std::any_of(triangles.healed.begin(), triangles.healed.end(), [&](const HealedFace& healed) {
      return healed.meshing == FaceMeshing::WithOther && healed.face.IsSame(face);
    });
  };
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
    if (isInOther(at.Current())) continue;
    const TopoDS_Face& face = TopoDS::Face(at.Current());
    addFace(face, entities.nameOf(face), triangles);
  }
  for (const HealedFace& healed : triangles.healed) {
    if (healed.meshing == FaceMeshing::Failed && healed.fault != FaceFault::NoTriangles) {
      ++triangles.record.facesWithoutMesh;
    }
  }
  compareVolumes(shape, triangles);
  resize(triangles, scale, mirrored);
  count(triangles);
  return triangles;
}

StepTriangles trianglesOf(const StepTessellation& held, double scale, bool mirrored) {
  StepTriangles triangles;
  triangles.vertices = held.vertices;
  triangles.indices = held.indices;
  resize(triangles, scale, mirrored);
  count(triangles);
  return triangles;
}

}  // namespace glissade
