#pragma once

#include <optional>

#include "engine/planning/operator_sample.h"
#include "engine/planning/planner.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// The way of the operator's hand as a tree of the roadmap. Each piece of it is a straight motion between poses of the
/// hand, proved to keep the required clearance. The trail goes on from its last node; where a piece cannot be proved,
/// it begins anew. Each new node is joined to every other tree to which the straight motion is proved.
class HandTrail {
 public:
  using Node = RoadmapGraph::Node;

  explicit HandTrail(const Problem& problem) : problem_(problem) {}

  /// Continues the trail to the pose of the hand.
  void follow(const OperatorSample& device, RoadmapGraph& roadmap, CollisionQuery& query, PlannerHost& host);
  /// Whether the hand has left the start.
  bool handHasMoved() const { return hasMoved_; }

  /// A part of the trail within one tree.
  struct Stretch {
    Node beginning = 0;
    Node end = 0;
    double length = 0.0;  ///< of the hand's motion, metres in the metric
  };
  /// The longest one; nothing before the hand has moved.
  const std::optional<Stretch>& longest() const { return longest_; }

 private:
  struct Growth;

  bool begin(const Pose& q, Growth& growth);
  bool goOn(const Pose& q, Growth& growth);
  void goTo(Node node, Growth& growth);
  void add(const Pose& q, Growth& growth);

  Problem problem_;
  bool hasMoved_ = false;
  bool continues_ = false;      ///< the hand is on the trail
  std::optional<Pose> seen_;    ///< pose of the hand at the last call
  std::optional<Pose> beyond_;  ///< pose of the hand after the last node, to which the motion is proved
  Stretch current_;
  std::optional<Stretch> longest_;
};

}  // namespace glissade
