#pragma once

#include <string>
#include <vector>

#include "engine/product/joint.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// Those of the joints that count where joints are used so; none where they are off.
Joints countingJoints(const Joints& joints, JointUse use);

/// What the joints of a product demand of the order of removals and of their motions. Immutable, shared by threads.
///
/// A joint of a screw or a nut is *closed* while the fastener and something that it is screwed into are there. What it
/// clamps stays until then, its thread comes apart by turning only. What is pressed in, welded or a unit is one body.
class JointRules {
 public:
  /// `joints`: those that count, of this product. `fasteners`: of each body; a nut may be turned off a screw.
  JointRules(Joints joints, const AssembledProduct& product, const std::vector<FastenerKind>& fasteners);

  const Joints& joints() const { return joints_; }
  /// Bodies that are one: host and guest of an insert, units, what is permanent. Several bodies each, no body in two.
  const std::vector<BodyGroup>& bonded() const { return bonded_; }

  /// Joints that hold the group where it is, ascending. `strict`: a screw leaves before what it clamps although its nut
  /// has left.
  std::vector<std::size_t> holding(const BodyGroup& group, const BodySet& present, bool strict) const;
  /// Closed threads that the group is on one side of: it has to be turned out of them.
  std::vector<std::size_t> opened(const BodyGroup& group, const BodySet& present) const;
  /// Of these joints, the bodies that are not in the group and have to leave before it, ascending.
  BodyGroup holders(const std::vector<std::size_t>& joints, const BodyGroup& group, const BodySet& present) const;
  /// Pairs of bodies of closed joints: the second one does not move unless the first one does.
  std::vector<std::pair<std::size_t, std::size_t>> links(const BodySet& present) const;

  /// The body leaves without a proof.
  bool isFlexible(std::size_t body) const { return isFlexible_[body]; }
  /// Alike joints that clamp the same bodies: the number of the body's task, from 1; 0: it is in none with others.
  std::size_t taskOf(std::size_t body) const { return tasks_[body]; }

  /// "held by 4 screws M3x8", for people.
  std::string inWords(const std::vector<std::size_t>& joints) const;

 private:
  bool isClosed(const Joint& joint, const BodySet& present) const;
  std::vector<std::size_t> jointsOf(const BodyGroup& group) const;
  void bond(const AssembledProduct& product);
  void findTasks(const AssembledProduct& product);

  Joints joints_;
  std::vector<BodyGroup> bonded_;
  std::vector<std::vector<std::size_t>> ofBody_;  ///< joints of screws, nuts and flexible bodies, of each body
  std::vector<bool> isFlexible_;
  std::vector<bool> isNut_;  ///< the body is turned off a shaft
  std::vector<std::size_t> tasks_;
};

}  // namespace glissade
