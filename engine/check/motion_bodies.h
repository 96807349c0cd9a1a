#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/check/evidence_names.h"
#include "engine/check/motion_check.h"
#include "engine/evidence/thinning.h"
#include "engine/evidence/thread_core.h"

namespace glissade::check {

/// Thinned bodies and obstacles for the judgement of motions of one product, each made once. Thread-safe.
class MotionBodies {
 public:
  /// `bodies`: all bodies of the product that motions may be judged against. `keptTriangles`: limit of the obstacles'
  /// triangles, about half a kilobyte each; beyond it the obstacles that were unused for longest are dropped.
  explicit MotionBodies(const std::vector<Body>& bodies, std::size_t keptTriangles = 400'000);

  /// The scale for motions in which these meshes take part: the product's, unless the meshes are larger.
  double scaleFor(const std::vector<const TriangleMesh*>& meshes, const std::vector<Body>& placed) const;
  /// The mesh thinned by the allowance of each triangle; the mesh itself if there are none. `share`: see thinned().
  /// `core`: the core that remains of its thread; null: the thread is kept.
  MeshPtr taken(const MeshPtr& mesh, const std::vector<double>& allowances, double share = kThicknessShare,
                const ThreadCore* core = nullptr);
  MotionCheck::ObstaclePtr obstacle(const MeshPtr& mesh, const Pose& X_WB, double scale);

 private:
  struct Prepared {
    MotionCheck::ObstaclePtr obstacle;
    std::uint64_t askedAt = 0;
  };
  using Place = std::pair<MeshPtr, std::vector<double>>;  ///< mesh, and the numbers of its pose and scale
  void forgetOldest();

  double scale_;
  std::size_t keptTriangles_;
  std::mutex mutex_;  ///< protects the members below
  std::map<std::tuple<MeshPtr, std::vector<double>, double, std::optional<ThreadCore>>, MeshPtr> thinned_;
  std::map<Place, Prepared> obstacles_;
  std::size_t triangles_ = 0;  ///< number of the obstacles' triangles
  std::uint64_t asked_ = 0;
};

}  // namespace glissade::check
