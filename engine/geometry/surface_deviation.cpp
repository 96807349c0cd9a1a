#include "engine/geometry/surface_deviation.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/nearest_point.h"
#include "engine/geometry/node_samples.h"

namespace glissade {
namespace {

using Corners = std::array<Vector3, 3>;
using Kind = SurfaceFace::Kind;

/// Signed distance from a cylinder or a cone: cosine * (distance from the axis - slope * height - radius). It is
/// convex, so that its maximum on a triangle is at a corner. Its minimum is on an edge or where the axis passes through
/// the triangle, because its gradient is constant along each line of the cone.
class Slanted {
 public:
  explicit Slanted(const SurfaceFace& face)
      : face_(face), angle_(face.kind == Kind::Cone ? face.second : 0.0), slope_(std::tan(angle_)) {}

  double at(const Vector3& p) const {
    const Vector3 from = p - face_.point;
    const double height = from.dot(face_.axis);
    return std::cos(angle_) * ((from - height * face_.axis).norm() - slope_ * height - face_.radius);
  }

  /// The minimum between a and b, where the derivative of the distance from the axis equals that of slope * height.
  double leastBetween(const Vector3& a, const Vector3& b) const {
    const Vector3 along = b - a;
    const Vector3 from = a - face_.point;
    const double rise = along.dot(face_.axis);
    const Vector3 across = along - rise * face_.axis;
    const Vector3 start = from - from.dot(face_.axis) * face_.axis;
    const double squared = across.squaredNorm();
    const double wanted = slope_ * rise;
    if (!(squared > wanted * wanted)) return std::min(at(a), at(b));
    const double product = across.dot(start);
    const double rest = std::max(0.0, start.squaredNorm() - product * product / squared);
    const double t = (wanted * std::sqrt(rest * squared / (squared - wanted * wanted)) - product) / squared;
    return at(a + std::clamp(t, 0.0, 1.0) * along);
  }

  /// The value where the axis passes through the triangle; the value at a corner where it does not.
  double leastOnTheAxis(const Corners& corners) const {
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double along = normal.dot(face_.axis);
    if (along == 0.0) return at(corners[0]);
    const Vector3 p = face_.point + face_.axis * (normal.dot(corners[0] - face_.point) / along);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 side = corners[(i + 1) % 3] - corners[i];
      if (side.cross(p - corners[i]).dot(normal) < 0.0) return at(corners[0]);
    }
    return at(p);
  }

 private:
  const SurfaceFace& face_;
  double angle_;
  double slope_;
};

double deviationOfSlanted(const SurfaceFace& face, const Corners& corners) {
  const Slanted slanted(face);
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    most = std::max(
        {most, std::abs(slanted.at(corners[i])), std::abs(slanted.leastBetween(corners[i], corners[(i + 1) % 3]))});
  }
  return std::max(most, std::abs(slanted.leastOnTheAxis(corners)));
}

double deviationOfTorus(const SurfaceFace& face, const Corners& corners) {
  constexpr int kParts = 8;
  TriangleSamples<kParts> samples;
  for (int i = 0; i <= kParts; ++i) {
    for (int j = 0; i + j <= kParts; ++j) {
      const Vector3 p = (i * corners[0] + j * corners[1] + (kParts - i - j) * corners[2]) / kParts;
      samples.at(i, j) = signedDistance(face, p);
    }
  }
  return samples.largest();
}

double largestAtCorners(const SurfaceFace& face, const Corners& corners) {
  double most = 0.0;
  for (const Vector3& corner : corners) most = std::max(most, std::abs(signedDistance(face, corner)));
  return most;
}

}  // namespace

double signedDistance(const SurfaceFace& face, const Vector3& p) {
  switch (face.kind) {
    case Kind::Cylinder:
    case Kind::Cone: return Slanted(face).at(p);
    case Kind::Sphere: return (p - face.point).norm() - face.radius;
    case Kind::Torus: {
      const double height = (p - face.point).dot(face.axis);
      const double across = (p - face.point - height * face.axis).norm();
      return std::hypot(across - face.radius, height) - face.second;
    }
    case Kind::Plane:
    case Kind::Free: break;
  }
  return (p - face.point).dot(face.axis);
}

double deviationFrom(const SurfaceFace& face, const Corners& corners) {
  switch (face.kind) {
    case Kind::Cylinder:
    case Kind::Cone: return deviationOfSlanted(face, corners);
    case Kind::Sphere:
      return std::max(largestAtCorners(face, corners),
                      std::abs(signedDistance(face, nearestPoint(corners, face.point))));
    case Kind::Torus: return deviationOfTorus(face, corners);
    case Kind::Plane:
    case Kind::Free: break;
  }
  return largestAtCorners(face, corners);
}

}  // namespace glissade
