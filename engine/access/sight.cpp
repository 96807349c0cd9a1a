#include "engine/access/sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/access/surface_points.h"
#include "engine/geometry/least_rotation.h"
#include "engine/geometry/segment_box.h"

namespace glissade {
namespace {

constexpr std::size_t kPlacePoints = 64;
constexpr double kViewing = 0.5;  ///< distance of the eye from the place, metres
constexpr int kAzimuths = 8;
constexpr double kElevations[] = {0.0, 0.25 * std::numbers::pi};
/// Share of the way from the eye to a point beyond which a body is at the point, and not in front of it.
constexpr double kBefore = 1.0 - 1e-4;

}  // namespace

std::vector<Vector3> eyesAbout(const Box3& place, const Vector3& up) {
  const double distance = kViewing + 0.5 * place.diagonal().norm();
  const Quaternion upright = leastRotation(Vector3::UnitZ(), up);
  std::vector<Vector3> eyes{place.center() + distance * up};
  for (const double elevation : kElevations) {
    for (int i = 0; i < kAzimuths; ++i) {
      const double azimuth = 2.0 * std::numbers::pi * i / kAzimuths;
      const Vector3 way(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                        std::sin(elevation));
      eyes.push_back(place.center() + distance * (upright * way));
    }
  }
  return eyes;
}

Sight::Sight(const std::vector<RigidBody>& bodies) {
  for (const RigidBody& body : bodies) {
    const auto at = trees_.try_emplace(body.mesh, *body.mesh).first;
    bodies_.push_back({&at->second, inverse(body.X_WB), boundingBox(*body.mesh, body.X_WB)});
  }
}

std::optional<std::size_t> Sight::hiding(const Vector3& eye, const Vector3& point,
                                         const std::vector<std::size_t>& others) const {
  for (const std::size_t body : others) {
    const Placed& placed = bodies_[body];
    if (!segmentMeets(placed.box_W, eye, point - eye)) continue;
    const Vector3 origin = placed.X_BW * eye;
    if (placed.tree->firstHit(origin, placed.X_BW * point - origin, 0.0) < kBefore) return body;
  }
  return std::nullopt;
}

SightAnswer Sight::of(const TriangleMesh& place_W, const std::vector<Vector3>& eyes,
                      const std::vector<std::size_t>& others) {
  const std::vector<SurfacePoint> points = surfacePoints(place_W, kPlacePoints);
  SightAnswer best{eyes.front()};
  bool isFirst = true;
  for (const Vector3& eye : eyes) {
    std::map<std::size_t, std::size_t> hidden;
    std::size_t seen = 0;
    for (const SurfacePoint& point : points) {
      const auto body = hiding(eye, point.p, others);
      if (body) ++hidden[*body];
      if (!body) ++seen;
    }
    const double share = points.empty() ? 0.0 : static_cast<double>(seen) / static_cast<double>(points.size());
    if (!isFirst && share <= best.share) continue;
    isFirst = false;
    const auto most = std::max_element(hidden.begin(), hidden.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    best = {eye, share, most == hidden.end() ? std::nullopt : std::optional(most->first)};
  }
  return best;
}

}  // namespace glissade
