#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/contact_planes.h"
#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Extensions of a tree that go on in contact where their straight motion is blocked: the nearest motion that the
/// tangent planes of the obstacles leave (L. Zhang, D. Manocha, "An efficient retraction-based RRT planner", 2008,
/// retract blocked configurations to contact; the planes are those of the god-object, M. Ortega, S. Redon, S.
/// Coquillart 2007). What blocks the motion in spite of the planes that are known is learnt from one distance. A node
/// that was reached by sliding begins with the planes of its parent, so that a way along surfaces costs few distances.
class SlidingExtension {
 public:
  using Node = std::uint32_t;

  /// `range`: of the extensions, in the metric of the search. The query is kept.
  SlidingExtension(CollisionQuery& query, const Box3& bounds, const Se3Metric& metric, double range);

  /// Where the extension of a node at q ends whose motion to `target` is blocked; nothing where it does not get on.
  /// Motions are sampled at `step` (freeFraction()).
  std::optional<Pose> slide(Node from, const Pose& q, const Pose& target, double step, const StopToken& stop);
  /// The extension of `from` that was found last has become this node.
  void keep(Node from, Node child);

 private:
  using Planes = std::shared_ptr<const ContactPlanes>;

  Planes& planesOf(Node node);
  bool learn(ContactPlanes& planes, const Pose& q, const Pose& blocked);

  CollisionQuery& query_;
  Box3 bounds_;
  Se3Metric metric_;
  ContactPlanes::Rule rule_;
  std::vector<Planes> planes_;  ///< per node; null: none are known
};

}  // namespace glissade
