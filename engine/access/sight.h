#pragma once

#include <map>
#include <optional>
#include <vector>

#include "engine/geometry/triangle_tree.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// Least share of the points of a place that has to be visible.
inline constexpr double kLeastSeen = 0.1;

/// Visibility of a place from the best of the tried head positions.
struct SightAnswer {
  Vector3 eye = Vector3::Zero();
  double share = 0.0;                      ///< visible share of the points of the assembled surface
  std::optional<std::size_t> blockedBy{};  ///< the body that hides most of the other points
  bool isSeen() const { return share >= kLeastSeen; }
};

/// Eyes half a metre from the place, in 17 directions at and above the horizon. `up`: unit.
std::vector<Vector3> eyesAbout(const Box3& place, const Vector3& up);

/// Lines of sight among bodies. Each mesh is prepared once. Used by one thread.
class Sight {
 public:
  explicit Sight(const std::vector<RigidBody>& bodies);

  /// Tests the visibility of points of the surface, in the world, among the chosen bodies. Precondition: there is an
  /// eye.
  SightAnswer of(const TriangleMesh& place_W, const std::vector<Vector3>& eyes, const std::vector<std::size_t>& others);

 private:
  struct Placed {
    const TriangleTree* tree;
    Pose X_BW;
    Box3 box_W;
  };
  /// The first of the chosen bodies that hides the point.
  std::optional<std::size_t> hiding(const Vector3& eye, const Vector3& point,
                                    const std::vector<std::size_t>& others) const;

  std::map<MeshPtr, TriangleTree> trees_;
  std::vector<Placed> bodies_;
};

}  // namespace glissade
