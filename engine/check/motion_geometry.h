#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "engine/check/course.h"
#include "engine/check/edge_proof.h"
#include "engine/check/evidence_names.h"
#include "engine/check/helix.h"
#include "engine/check/motion_check.h"
#include "engine/check/sweep.h"
#include "engine/evidence/ray_containment.h"
#include "engine/evidence/turn.h"
#include "engine/geometry/fcl_scale.h"

/// Private data of MotionCheck, included by its implementation only.
namespace glissade::check {
namespace distances {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

/// Relative error of FCL's distances between triangles, and error as a share of the largest coordinate that enters:
/// about 16 roundings.
inline constexpr double kRelativeError = 1e-9;
inline constexpr double kCoordinateError = 4e-15;
/// If the error exceeds this share of the clearance, the motion is undecided.
inline constexpr double kErrorShare = 0.05;

/// Distance of two surfaces. If none is nearer than `enough`, the result is `enough`, without points.
inline fcl::DistanceResultd between(const Model& fixed, const Model& moving, const fcl::Transform3d& X_WB,
                                    double enough) {
  fcl::DistanceResultd gap(enough);
  fcl::distance(&fixed, fcl::Transform3d::Identity(), &moving, X_WB, fcl::DistanceRequestd(true), gap);
  return gap;
}

inline void addTriangles(Model& model, const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> points(mesh.vertices.begin(), mesh.vertices.end());
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  model.addSubModel(points, triangles);
}

inline std::vector<Corners> cornersOf(const Model& model) {
  std::vector<Corners> corners;
  for (int i = 0; i < model.num_tris; ++i) {
    const fcl::Triangle& triangle = model.tri_indices[i];
    corners.push_back({model.vertices[triangle[0]], model.vertices[triangle[1]], model.vertices[triangle[2]]});
  }
  return corners;
}

/// A surface for FCL's distances, and for proofs by pieces, whose tree is built at first use.
struct Surface {
  Model model;

  explicit Surface(const TriangleMesh& mesh) {
    model.beginModel();
    addTriangles(model, mesh);
    model.endModel();
  }
  const PieceTree& pieces() const {
    std::call_once(made_, [this] { pieces_.emplace(cornersOf(model)); });
    return *pieces_;
  }

 private:
  mutable std::once_flag made_;
  mutable std::optional<PieceTree> pieces_;
};

}  // namespace distances

struct MotionCheck::Obstacle {
  RaySolid solid;
  distances::Surface surface;
  Box3 box;  ///< scaled, world frame
  double farthest;

  explicit Obstacle(const TriangleMesh& placed)
      : solid(placed), surface(placed), box(boundingBox(placed)), farthest(largestCoordinate(placed)) {}
};

/// Obstacles against which the object has the same shape. All lengths are multiplied by `scale`, including those of
/// poses in queries.
struct MotionCheck::Group {
  TriangleMesh object;
  RaySolid objectSolid;
  distances::Surface objectSurface;
  Vector3 middle;  ///< centre of the object
  double radius;   ///< radius about `middle`
  std::vector<ObstaclePtr> obstacles;
  std::vector<int> numbers;  ///< numbers of the obstacles
  double coordinates;        ///< largest coordinate of the obstacles plus that of the object in its own frame

  Group(const TriangleMesh& mesh, double scale)
      : object(welded(scaled(mesh, Vector3::Constant(scale)))),
        objectSolid(object),
        objectSurface(object),
        middle(boundingBox(object).center()),
        radius(0.0),
        coordinates(largestCoordinate(object)) {
    for (const Vector3& vertex : object.vertices) radius = std::max(radius, (vertex - middle).norm());
  }

  void add(const ObstaclePtr& obstacle, int number) {
    farthest_ = std::max(farthest_, obstacle->farthest);
    obstacles.push_back(obstacle);
    numbers.push_back(number);
  }

  void finish() { coordinates += farthest_; }

  /// Error of distances when the object is at this position.
  double errorAt(const Vector3& position) const {
    return distances::kCoordinateError * (coordinates + position.cwiseAbs().maxCoeff());
  }

  /// Lower bound on the distance of the object from the obstacle, without the rounding that errorAt() covers.
  double leastDistance(const Obstacle& obstacle, const fcl::Transform3d& X_WB) const {
    return obstacle.box.exteriorDistance(Vector3(X_WB * middle)) * (1.0 - distances::kRelativeError) -
           radius * (1.0 + distances::kRelativeError);
  }

  /// The nearest obstacle within `enough`; infinite distance if there is none.
  Nearest nearest(const fcl::Transform3d& X_WB, double enough) const {
    Nearest found;
    found.distance = std::numeric_limits<double>::infinity();
    const double error = errorAt(X_WB.translation());
    for (const auto& [least, i] : byLeastDistance(X_WB)) {
      const double wanted = std::min(enough, found.distance);
      if (least > wanted + error) break;
      const Obstacle& obstacle = *obstacles[i];
      if (touches(obstacle, objectSurface.model, X_WB)) {
        found.distance = 0.0;
        found.body = numbers[i];
        return found;
      }
      const double reach = (wanted + error) * (1.0 + 4.0 * distances::kRelativeError);
      const fcl::DistanceResultd gap = distances::between(obstacle.surface.model, objectSurface.model, X_WB, reach);
      const double distance = std::max(0.0, gap.min_distance * (1.0 - distances::kRelativeError) - error);
      if (distance >= wanted) continue;
      found.distance = distance;
      found.body = numbers[i];
      found.onBody = gap.nearest_points[0];
      found.onMoving = gap.nearest_points[1];
    }
    return found;
  }

  /// The obstacle that is nearest on a straight motion without a turn, with a lower bound on the distance. An obstacle
  /// that touches no prism's boundary is inside of a prism or outside of all. Obstacles farther than `enough` are not
  /// measured exactly.
  Nearest nearestToSweep(const fcl::Transform3d& X_WB, const Vector3& way, double enough) const {
    TriangleMesh placed = object;
    for (Vector3& vertex : placed.vertices) vertex = X_WB * vertex;
    Box3 box = boundingBox(placed);
    box.extend(Box3(box.min() + way, box.max() + way));
    const double error = std::max(errorAt(X_WB.translation()), errorAt(X_WB.translation() + way));
    Nearest least;
    least.distance = std::numeric_limits<double>::infinity();
    std::unique_ptr<distances::Model> swept;
    for (std::size_t i = 0; i < obstacles.size() && least.distance > 0.0; ++i) {
      const double apart =
          std::max(0.0, obstacles[i]->box.exteriorDistance(box) * (1.0 - distances::kRelativeError) - error);
      if (apart > enough) {
        if (apart < least.distance) least = {apart, numbers[i]};
        continue;
      }
      if (!swept) {
        swept = std::make_unique<distances::Model>();
        swept->beginModel();
        distances::addTriangles(*swept, sweptBy(placed, way));
        swept->endModel();
      }
      // A little more than is wanted, so that rounding puts no farther obstacle before the nearest one.
      const double reach = (std::min(enough, least.distance) + error) * (1.0 + 4.0 * distances::kRelativeError);
      const double distance = sweptDistance(*obstacles[i], *swept, placed, way, reach, error);
      if (distance < least.distance) least = {distance, numbers[i]};
    }
    return least;
  }

  /// The bound is limited to about `enough`.
  static double sweptDistance(const Obstacle& obstacle, const distances::Model& swept, const TriangleMesh& placed,
                              const Vector3& way, double enough, double error) {
    const fcl::Transform3d fixed = fcl::Transform3d::Identity();
    if (touches(obstacle, swept, fixed)) return 0.0;
    for (const Vector3& point : obstacle.solid.partPoints()) {
      for (const auto& [a, b, c] : placed.triangles) {
        if (passesOver(placed.vertices[a], placed.vertices[b], placed.vertices[c], way, point)) return 0.0;
      }
    }
    const double distance = distances::between(obstacle.surface.model, swept, fixed, enough).min_distance;
    return std::max(0.0, distance * (1.0 - distances::kRelativeError) - error);
  }

  /// Lower bound on the distance while the object turns about the axis by any angle and rises along it.
  double turnedDistance(const fcl::Transform3d& X_WB, const Vector3& point, const Vector3& axis, const Rise& rise,
                        const StopToken& stop) const {
    std::vector<TurnedTriangle> moving;
    for (const auto& [a, b, c] : object.triangles) {
      moving.push_back(
          turned(X_WB * object.vertices[a], X_WB * object.vertices[b], X_WB * object.vertices[c], point, axis));
    }
    std::vector<TurnedTriangle> fixed;
    for (const Corners& corners : fixedCorners()) {
      fixed.push_back(turned(corners[0], corners[1], corners[2], point, axis));
    }
    const double error = std::max(errorAt(X_WB.translation() + rise.least * axis), errorAt(X_WB.translation())) +
                         errorAt(X_WB.translation() + rise.most * axis);
    const double least = check::turnedDistance(moving, fixed, rise, stop);
    return std::max(0.0, least * (1.0 - distances::kRelativeError) - error);
  }

  /// Lower bound on the distance on a screw motion, for any number of turns; at most `enough`.
  double helixDistance(const fcl::Transform3d& X_WB, const Helix& helix, double wanted, double enough,
                       const StopToken& stop) const {
    std::vector<Corners> moving;
    for (const auto& [a, b, c] : object.triangles) {
      moving.push_back({X_WB * object.vertices[a], X_WB * object.vertices[b], X_WB * object.vertices[c]});
    }
    const double error = errorAt(X_WB.translation()) + errorAt(X_WB.translation() + helix.advance * helix.axis);
    const double least = check::helixDistance(moving, fixedCorners(), helix, wanted + 2.0 * error, enough, stop);
    return std::max(0.0, least * (1.0 - distances::kRelativeError) - error);
  }

  /// Number of the body that contains the object or is contained in it; -1 if there is none.
  int container(const fcl::Transform3d& X_WB) const {
    const fcl::Transform3d X_BW = X_WB.inverse();
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      const RaySolid& obstacle = obstacles[i]->solid;
      for (const Vector3& p : objectSolid.partPoints()) {
        if (obstacle.contains(X_WB * p)) return numbers[i];
      }
      for (const Vector3& p : obstacle.partPoints()) {
        if (objectSolid.contains(X_BW * p)) return numbers[i];
      }
    }
    return -1;
  }

 private:
  static bool touches(const Obstacle& obstacle, const distances::Model& moving, const fcl::Transform3d& X_WB) {
    fcl::CollisionResultd touch;
    return fcl::collide(&obstacle.surface.model, fcl::Transform3d::Identity(), &moving, X_WB, fcl::CollisionRequestd(),
                        touch) > 0;
  }

  /// The obstacles in the order of leastDistance(), the nearest first.
  std::vector<std::pair<double, std::size_t>> byLeastDistance(const fcl::Transform3d& X_WB) const {
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < obstacles.size(); ++i) sorted.emplace_back(leastDistance(*obstacles[i], X_WB), i);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

  std::vector<Corners> fixedCorners() const {
    std::vector<Corners> corners;
    for (const ObstaclePtr& obstacle : obstacles) {
      const std::vector<Corners> own = distances::cornersOf(obstacle->surface.model);
      corners.insert(corners.end(), own.begin(), own.end());
    }
    return corners;
  }

  double farthest_ = 0.0;
};

/// The groups, all in one scale.
struct MotionCheck::Geometry {
  double scale = 1.0;
  TriangleMesh object;  ///< whole object: no vertex of a thinned shape is faster
  std::vector<std::unique_ptr<Group>> groups;

  double errorAt(const Vector3& position) const {
    double error = 0.0;
    for (const auto& group : groups) error = std::max(error, group->errorAt(position));
    return error;
  }
  /// True if distances along the straight motion are exact enough for a comparison with this clearance.
  bool resolves(const Pose& from, const Pose& to, double clearance) const {
    return std::max(errorAt(from.position), errorAt(to.position)) <= distances::kErrorShare * clearance;
  }

  /// The nearest obstacle within `enough` in the groups with `asked`; infinite distance if there is none.
  Nearest nearest(const fcl::Transform3d& X_WB, double enough, const std::vector<bool>& asked) const {
    Nearest nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (!asked[i]) continue;
      const Nearest found = groups[i]->nearest(X_WB, std::min(enough, nearest.distance));
      if (found.distance < nearest.distance) nearest = found;
    }
    return nearest;
  }

  Nearest nearestToSweep(const fcl::Transform3d& X_WB, const Vector3& way, double enough,
                         const std::vector<bool>& asked) const {
    Nearest least;
    least.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size() && least.distance > 0.0; ++i) {
      if (!asked[i]) continue;
      const Nearest found = groups[i]->nearestToSweep(X_WB, way, enough);
      if (found.distance < least.distance) least = found;
    }
    return least;
  }

  /// Proves the clearance of a turn about the axis for any angle, group by group; clears `asked` of the groups that
  /// keep it. Returns the least proved distance.
  double proveTurn(const fcl::Transform3d& X_WB, const Vector3& point, const Vector3& axis, const Rise& rise,
                   double required, std::vector<bool>& asked, const StopToken& stop) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (!asked[i]) continue;
      const double proved = groups[i]->turnedDistance(X_WB, point, axis, rise, stop);
      asked[i] = proved < required;
      if (!asked[i]) least = std::min(least, proved);
    }
    return least;
  }

  int container(const fcl::Transform3d& X_WB) const {
    for (const auto& group : groups) {
      if (const int body = group->container(X_WB); body >= 0) return body;
    }
    return -1;
  }
};

}  // namespace glissade::check
