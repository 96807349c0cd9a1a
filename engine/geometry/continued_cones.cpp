#include "engine/geometry/continued_cones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "engine/geometry/range.h"

namespace glissade {
namespace {

/// Largest sine of the angle between two axes that are one, and largest distance, metres.
constexpr double kSameAxis = 1e-6;
constexpr double kSameLength = 1e-6;

/// Ranges of the vertices of a face about an axis.
struct Turned {
  Range radius;
  Range height;
};

double radiusAbout(const SurfaceFace& axis, const Vector3& p) { return (p - axis.point).cross(axis.axis).norm(); }

Vector3 outwards(const SurfaceFace& axis, const Vector3& p) {
  const Vector3 from = p - axis.point;
  return (from - axis.axis * axis.axis.dot(from)).stableNormalized();
}

class ConeFinder {
 public:
  explicit ConeFinder(const TriangleMesh& mesh) : mesh_(mesh) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const SurfaceFace::Kind kind = mesh.faces[mesh.faceOf[t]].kind;
      if (kind == SurfaceFace::Kind::Cylinder) cylinders_[mesh.faceOf[t]].push_back(t);
      if (kind == SurfaceFace::Kind::Cone) cones_[mesh.faceOf[t]].push_back(t);
    }
  }

  std::vector<ConeVertex> find() {
    for (const auto& [cylinder, triangles] : cylinders_) {
      for (const auto& [cone, others] : cones_) {
        if (isCoaxial(mesh_.faces[cone], mesh_.faces[cylinder])) compare(cylinder, triangles, cone, others);
      }
    }
    return std::move(found_);
  }

 private:
  using Triangles = std::vector<std::uint32_t>;

  static bool isCoaxial(const SurfaceFace& cone, const SurfaceFace& axis) {
    return cone.axis.cross(axis.axis).norm() <= kSameAxis && radiusAbout(axis, cone.point) <= kSameLength;
  }

  Turned about(const SurfaceFace& axis, const Triangles& triangles) const {
    Turned turned;
    for (const std::uint32_t t : triangles) {
      for (const std::uint32_t i : mesh_.triangles[t]) {
        turned.radius.take(radiusAbout(axis, mesh_.vertices[i]));
        turned.height.take((mesh_.vertices[i] - axis.point).dot(axis.axis));
      }
    }
    return turned;
  }

  /// True for a shaft: the normals point away from the axis. False for a hole.
  bool isShaft(const SurfaceFace& axis, std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Vector3& p = mesh_.vertices[a];
    const Vector3 normal = (mesh_.vertices[b] - p).cross(mesh_.vertices[c] - p);
    return normal.dot(outwards(axis, p)) > 0.0;
  }

  void compare(std::uint32_t cylinder, const Triangles& ofCylinder, std::uint32_t cone, const Triangles& ofCone) {
    const SurfaceFace& axis = mesh_.faces[cylinder];
    const bool shaft = isShaft(axis, ofCylinder.front());
    if (isShaft(axis, ofCone.front()) != shaft) return;
    const Turned own = about(axis, ofCylinder);
    const Turned others = about(axis, ofCone);
    const double slack = kSameLength + axis.deflection + mesh_.faces[cone].deflection;
    const double begins = shaft ? others.radius.high : others.radius.low;
    const bool meets = std::abs(others.height.low - own.height.high) <= slack ||
                       std::abs(own.height.low - others.height.high) <= slack;
    if (!meets || std::abs(begins - axis.radius) > slack) return;
    std::set<std::uint32_t> vertices;
    for (const std::uint32_t t : ofCone) vertices.insert(mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    const double sense = shaft ? 1.0 : -1.0;
    for (const std::uint32_t i : vertices) {
      const Vector3& p = mesh_.vertices[i];
      const double recedes = std::max(0.0, sense * (axis.radius - radiusAbout(axis, p)));
      found_.push_back({i, cylinder, -sense * outwards(axis, p), recedes});
    }
  }

  const TriangleMesh& mesh_;
  std::map<std::uint32_t, Triangles> cylinders_;  ///< triangles by face
  std::map<std::uint32_t, Triangles> cones_;
  std::vector<ConeVertex> found_;
};

}  // namespace

std::vector<ConeVertex> coneVertices(const TriangleMesh& mesh) {
  return mesh.faces.empty() ? std::vector<ConeVertex>() : ConeFinder(mesh).find();
}

void moveCones(const std::vector<ConeVertex>& vertices, const std::vector<double>& taken, std::vector<Vector3>& moves) {
  std::set<std::uint32_t> cylinders;  // cylinders with a vertex between them and the thinned ones
  for (const ConeVertex& each : vertices) {
    if (each.recedes > kSameLength && each.recedes < taken[each.cylinder]) cylinders.insert(each.cylinder);
  }
  for (const ConeVertex& each : vertices) {
    if (cylinders.count(each.cylinder) == 0) continue;
    moves[each.vertex] = std::max(0.0, taken[each.cylinder] - each.recedes) * each.inwards;
  }
}

}  // namespace glissade
