#pragma once

#include <optional>

#include "engine/planning/operator_sample.h"
#include "engine/planning/planner.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// The way of the operator's hand as a tree of the roadmap. Each piece of it is a straight motion between poses of the
/// hand, proved to keep the required clearance. The trail goes on from its last node; where a piece cannot be proved,
/// or the object was put elsewhere, it begins anew. Each new node is joined to every other tree to which the straight
/// motion is free.
class HandTrail {
 public:
  using Node = RoadmapGraph::Node;

  explicit HandTrail(const Problem& problem) : problem_(problem) {}

  /// Continues the trail to the pose of the hand.
  void follow(const OperatorSample& device, RoadmapGraph& roadmap, CollisionQuery& query, PlannerHost& host);
  /// The node at which the trail ends, or ended last; nothing before the hand has moved.
  std::optional<Node> end() const { return end_; }
  /// The node at which that trail begins. Precondition: it has an end.
  Node beginning() const { return beginning_; }

 private:
  struct Growth;

  void begin(const Pose& q, Growth& growth);
  bool goOn(const Pose& q, Growth& growth);
  void add(const Pose& q, Growth& growth);

  Problem problem_;
  std::optional<Node> end_;
  Node beginning_ = 0;
  bool continues_ = false;      ///< the hand is on the trail
  std::optional<Pose> beyond_;  ///< pose of the hand after end_, to which the motion is proved
  std::optional<Pose> seen_;    ///< pose of the hand at the last call
};

}  // namespace glissade
