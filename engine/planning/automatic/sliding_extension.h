#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/contact_planes.h"
#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Extensions of a tree that go on in contact where their straight motion is blocked. They take the nearest motion that
/// the tangent planes of the obstacles permit (L. Zhang, D. Manocha, "An efficient retraction-based RRT planner", 2008,
/// retract blocked configurations to contact; the planes are those of the god-object, M. Ortega, S. Redon, S.
/// Coquillart 2007). Where the known planes do not explain a blocked motion, one distance query gives a new plane. A
/// node that was reached by sliding begins with the planes of its parent, so that a way along surfaces costs few
/// distance queries.
class SlidingExtension {
 public:
  using Node = std::uint32_t;

  /// `range`: range of the extensions, in the metric of the search. The query must outlive this object.
  SlidingExtension(CollisionQuery& query, const Box3& bounds, const Se3Metric& metric, double range);

  /// The end of the blocked extension from a node at q towards `target`; nothing where it makes no progress. Motions
  /// are sampled at `step` (freeFraction()).
  std::optional<Pose> slide(Node from, const Pose& q, const Pose& target, double step, const StopToken& stop);
  /// Associates the planes of the extension found last from `from` with its new node.
  void keep(Node from, Node child);

 private:
  using Planes = std::shared_ptr<const ContactPlanes>;

  Planes& planesOf(Node node);
  bool learn(ContactPlanes& planes, const Pose& q, const Pose& blocked);

  CollisionQuery& query_;
  Box3 bounds_;
  Se3Metric metric_;
  ContactPlanes::Rule rule_;
  std::vector<Planes> planes_;  ///< one entry per node; null: no planes are known
};

}  // namespace glissade
