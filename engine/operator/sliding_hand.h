#pragma once

#include <memory>

#include "engine/operator/haptic/god_object.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// A person's device among obstacles. The device moves the hand, and the object follows the hand as a god-object: it
/// stops at contact and slides along. The hand leads by at most a part of the object's radius. After a release the hand
/// is where the object is, so that the next grip begins there. Near obstacles the hand is slower.
///
/// An object that was put into collision follows the hand freely until it is out. It also follows freely while the
/// world is not prepared yet.
class SlidingHand final : public OperatorDevice {
 public:
  /// Largest lead of the hand, and clearance below which it is slower, in radii of the object.
  static constexpr double kMostLead = 0.1;
  static constexpr double kSlowFrom = 0.5;
  /// Factor of the speed in contact.
  static constexpr double kSlowest = 0.5;

  SlidingHand(CollisionWorldPtr world, std::unique_ptr<OperatorDevice> device);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override;
  void regrip() override { placed_ = false; }
  bool connected() const override { return device_->connected(); }
  bool holds() const override { return device_->holds(); }
  std::optional<Wrench> rendered() const override;
  std::optional<Pose> hand() const override;

 private:
  Pose moved(double dt, const OperatorView& view, const Box3& bounds);
  Pose ledBy(double dt, const OperatorView& view, const Box3& bounds);
  void follow(double dt);
  void place(const Pose& q);

  CollisionWorldPtr world_;
  std::unique_ptr<OperatorDevice> device_;
  std::unique_ptr<CollisionQuery> query_;  ///< null until the world is prepared
  GodObject object_;
  Pose q_;     ///< pose of the object
  Pose hand_;  ///< pose to which the device has moved the hand
  double radius_;
  double clearance_;  ///< lower bound by the last query, metres
  bool placed_ = false;
};

}  // namespace glissade
