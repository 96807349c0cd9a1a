#pragma once

#include <optional>
#include <vector>

#include "engine/access/hand_search.h"
#include "engine/access/sight.h"
#include "engine/base/work_watch.h"
#include "engine/product/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Whose hand is asked about, and from where they look.
struct Person {
  HandSize size = HandSize::Average;
  std::optional<Vector3> eye{};  ///< world, metres; nothing: positions about the place are tried (eyesAbout())
};

/// Bodies that move as one away from where they are assembled, by index.
struct ReachedMotion {
  std::vector<std::size_t> bodies;
  std::vector<std::size_t> others;  ///< that are there meanwhile
  std::vector<Pose> moved;          ///< each body stands at moved * X_WB; the first one is the identity
  ToolKind tool = ToolKind::None;   ///< that turns the first body
  /// What the tool turns while the first body is held: the bolt of a nut, which stays; none of the others.
  std::optional<std::size_t> bolt{};
};

/// Whether a person gets to a motion with their hand, and sees where it begins. It is sampled: no proof.
struct MotionAccess {
  HandAnswer hand;
  HandFollow follow;               ///< how the hand goes with the bodies
  ToolKind tool = ToolKind::None;  ///< in the hand
  SightAnswer sight;
  std::vector<HandSample> samples{};  ///< that were asked, in their order

  bool isReached() const { return hand.access == HandAccess::Free; }
  bool isReachedAndSeen() const { return isReached() && sight.isSeen(); }
  bool hasHold() const { return hand.access == HandAccess::Free || hand.access == HandAccess::Blocked; }
};

/// Asks for the bodies of one product. Bodies stand where they are assembled. Not for several threads.
class AccessChecker {
 public:
  AccessChecker(const std::vector<RigidBody>& bodies, const Person& person);

  /// Without a head where the tool fits, the bare hand is asked. After a stop the hand's answer is NotAsked.
  MotionAccess of(const ReachedMotion& motion, const StopToken& stop);
  const Person& person() const { return person_; }
  /// Of the forearm of this person, in its frame.
  const MeshPtr& forearm() { return search_.shapes().forearm(); }

 private:
  struct Grip;
  Grip gripOf(const ReachedMotion& motion, const TriangleMesh& bodies_W);
  std::optional<Grip> toolGripOf(const ReachedMotion& motion, const Vector3& leaving);

  Person person_;
  PreparedBodies bodies_;
  HandSearch search_;
  Sight sight_;
};

}  // namespace glissade
