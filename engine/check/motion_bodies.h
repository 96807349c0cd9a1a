#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/check/motion_check.h"
#include "engine/check/thinning.h"
#include "engine/check/thread_core.h"

namespace glissade::check {

/// What motions of one product are judged against, made once for all of them: bodies taken thinner, and obstacles.
/// May be asked by several threads at a time.
class MotionBodies {
 public:
  /// `bodies`: of the product, all that motions may be judged against. `keptTriangles`: of obstacles, about half a
  /// kilobyte each; those that were not asked for longest are made again.
  explicit MotionBodies(const std::vector<Body>& bodies, std::size_t keptTriangles = 400'000);

  /// The scale of motions in which these meshes take part: of the product's, unless theirs is larger.
  double scaleFor(const std::vector<const TriangleMesh*>& meshes, const std::vector<Body>& placed) const;
  /// The mesh taken thinner by the allowance of each triangle; itself where there is none. `share`: as of thinned().
  /// `core`: that is left of its thread; null: all.
  MeshPtr taken(const MeshPtr& mesh, const std::vector<double>& allowances, double share = kThicknessShare,
                const ThreadCore* core = nullptr);
  MotionCheck::ObstaclePtr obstacle(const MeshPtr& mesh, const Pose& X_WB, double scale);

 private:
  struct Prepared {
    MotionCheck::ObstaclePtr obstacle;
    std::uint64_t askedAt = 0;
  };
  using Place = std::pair<MeshPtr, std::vector<double>>;  ///< a mesh, and the numbers of its pose and scale
  void forgetOldest();

  double scale_;
  std::size_t keptTriangles_;
  std::mutex mutex_;  ///< of what follows
  std::map<std::tuple<MeshPtr, std::vector<double>, double, std::optional<ThreadCore>>, MeshPtr> thinned_;
  std::map<Place, Prepared> obstacles_;
  std::size_t triangles_ = 0;  ///< of the obstacles
  std::uint64_t asked_ = 0;
};

}  // namespace glissade::check
