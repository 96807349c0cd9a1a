#pragma once

#include <map>
#include <optional>
#include <vector>

#include "engine/environment/rigid_body.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// Least share of the points of a place that has to be seen.
inline constexpr double kLeastSeen = 0.1;

/// What is seen of a place from the best of the positions of the head that were tried.
struct SightAnswer {
  Vector3 eye = Vector3::Zero();
  double share = 0.0;                      ///< of points of the surface that is to be there, past all other bodies
  std::optional<std::size_t> blockedBy{};  ///< the body that hides most of the others
  bool isSeen() const { return share >= kLeastSeen; }
};

/// Eyes half a metre from the place, in 17 directions at and above the horizon.
std::vector<Vector3> eyesAbout(const Box3& place);

/// Lines of sight among bodies. Each mesh is prepared once. Not for several threads.
class Sight {
 public:
  explicit Sight(const std::vector<RigidBody>& bodies);

  /// Looks at points of the surface, in the world, past the chosen bodies. Precondition: there is an eye.
  SightAnswer of(const TriangleMesh& place_W, const std::vector<Vector3>& eyes, const std::vector<std::size_t>& others);

 private:
  struct Placed {
    const TriangleTree* tree;
    Pose X_BW;
    Box3 box_W;
  };
  /// The body that hides the point, the first of the chosen ones.
  std::optional<std::size_t> hiding(const Vector3& eye, const Vector3& point,
                                    const std::vector<std::size_t>& others) const;

  std::map<MeshPtr, TriangleTree> trees_;
  std::vector<Placed> bodies_;
};

}  // namespace glissade
