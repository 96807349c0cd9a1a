#pragma once

#include <optional>
#include <vector>

#include "engine/access/hand_search.h"
#include "engine/access/sight.h"
#include "engine/base/work_watch.h"
#include "engine/fits/assembled_product.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// The person whose access is tested.
struct Person {
  HandSize size = HandSize::Average;
  std::optional<Vector3> eye{};  ///< world, metres; nothing: positions about the place are tried (eyesAbout())
};

/// Bodies that move as one from their assembled poses, by index.
struct ReachedMotion {
  std::vector<std::size_t> bodies;
  std::vector<std::size_t> others;  ///< bodies that are there during the motion
  std::vector<Pose> moved;          ///< displacements: each body is at moved * X_WB; the first one is the identity
  ToolKind tool = ToolKind::None;   ///< tool that turns the first body
  /// The bolt that the tool turns while the first body, its nut, is held; the bolt stays. Nothing: the tool turns the
  /// body.
  std::optional<std::size_t> bolt{};
  Vector3 up = Vector3::UnitZ();  ///< upward direction of the work place, unit
};

/// Result of a test whether a person's hand has access to a motion, and whether its beginning is visible. It is
/// sampled, and no proof.
struct MotionAccess {
  HandAnswer hand;
  HandFollow follow;               ///< how the hand follows the bodies
  ToolKind tool = ToolKind::None;  ///< tool in the hand
  SightAnswer sight;
  std::vector<HandSample> samples{};  ///< tested samples, in their order

  bool isReached() const { return hand.access == HandAccess::Free; }
  bool isReachedAndSeen() const { return isReached() && sight.isSeen(); }
  bool hasHold() const { return hand.access == HandAccess::Free || hand.access == HandAccess::Blocked; }
};

/// Tests access to motions of the bodies of one product, which are at their assembled poses. Used by one thread.
class AccessChecker {
 public:
  AccessChecker(const std::vector<RigidBody>& bodies, const Person& person);

  /// If the tool's head is not found, the bare hand is tested. After a stop the hand's answer is NotAsked.
  MotionAccess of(const ReachedMotion& motion, const StopToken& stop);
  const Person& person() const { return person_; }
  /// Mesh of this person's forearm, in its frame.
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
