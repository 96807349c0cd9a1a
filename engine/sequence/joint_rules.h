#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/fits/joint.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// The joints that count for this use; none if joints are off.
Joints countingJoints(const Joints& joints, JointUse use);

/// True if the bodies of the joint are one body while it counts.
bool isBonded(const Joint& joint);

/// Demands of a product's joints on the order of removals and on their motions. Immutable, shared by threads.
///
/// A joint of a screw or a nut is *closed* while the fastener and a part that it is screwed into are there. The clamped
/// parts stay until it is opened, and its thread comes apart by turning only. An insert and its host, welded parts and
/// units are one body.
class JointRules {
 public:
  /// `joints`: those that count, of this product. `fasteners`: kind of each body; a nut may be turned off a screw.
  JointRules(Joints joints, const AssembledProduct& product, const std::vector<FastenerKind>& fasteners);

  const Joints& joints() const { return joints_; }
  /// Bonded bodies: host and guest of an insert, units, permanent joints. Groups of several bodies; no body is in two.
  const std::vector<BodyGroup>& bonded() const { return bonded_; }

  /// Joints that hold the group where it is, ascending. `strict`: a screw leaves before the parts that it clamps
  /// although its nut has left.
  std::vector<std::size_t> holding(const BodyGroup& group, const BodySet& present, bool strict) const;
  /// Closed threads with a body of the group on one side only: the group has to be turned out of them.
  std::vector<std::size_t> opened(const BodyGroup& group, const BodySet& present) const;
  /// The bodies of these joints that are not in the group and have to leave before it, ascending.
  BodyGroup holders(const std::vector<std::size_t>& joints, const BodyGroup& group, const BodySet& present) const;
  /// Pairs of bodies of closed joints: the second body does not move unless the first one does.
  std::vector<std::pair<std::size_t, std::size_t>> links(const BodySet& present) const;

  /// True if the body is in a thread or has one, as the screw, the nut, or what they are screwed into.
  bool isScrewedTogether(std::size_t body) const;
  /// A flexible body leaves without a proof.
  bool isFlexible(std::size_t body) const { return isFlexible_[body]; }
  /// Number, from 1, of the body's fastener stack: a screw or a bolt with its nuts and washers, which a fitter puts in
  /// as one operation; 0: no stack.
  std::size_t stackOf(std::size_t body) const { return stackOf_[body]; }
  /// The bodies of each stack, ascending; the stack with number n is at n - 1.
  const std::vector<BodyGroup>& stacks() const { return stacks_; }
  /// Number, from 1, of the body's task (the stacks of alike joints that clamp the same bodies); 0: no task.
  std::size_t taskOf(std::size_t body) const { return tasks_[body]; }

  /// "4 screws M3x8 and 1 nut of 5 mm".
  Message inWords(const std::vector<std::size_t>& joints) const;

 private:
  bool isClosed(const Joint& joint, const BodySet& present) const;
  std::vector<std::size_t> jointsOf(const BodyGroup& group) const;
  void bond(const AssembledProduct& product);
  void findStacks(const std::vector<FastenerKind>& fasteners);
  void findTasks(const AssembledProduct& product);

  Joints joints_;
  std::vector<BodyGroup> bonded_;
  std::vector<std::vector<std::size_t>> ofBody_;  ///< for each body, its joints of screws, nuts and flexible bodies
  std::vector<bool> isFlexible_;
  std::vector<bool> isNut_;  ///< for each body, whether it is turned off a shaft
  std::vector<BodyGroup> stacks_;
  std::vector<std::size_t> stackOf_;
  std::vector<std::size_t> tasks_;
};

}  // namespace glissade
