#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "engine/base/diagnostic.h"
#include "engine/operator/operator_input.h"
#include "engine/planning/operator_sample.h"
#include "engine/planning/problem.h"
#include "engine/session/start_tree_distance.h"

namespace glissade {

/// Pose of the object in the operator's hand.
struct HandState {
  Pose q_device;
  std::uint64_t moves = 0;  ///< as in OperatorSample::moves
};

/// The operator's side of a session: q_device, its motion, and its nearest obstacle (paper 1, section III.A: reading
/// the device, integrating positions, cycling through obstacles). Owned and used by one thread.
class OperatorHand {
 public:
  /// The object is at the problem's start. `device` null: nobody holds it.
  OperatorHand(const Problem& problem, std::unique_ptr<OperatorDevice> device);

  bool held() const { return device_ != nullptr; }
  bool connected() const { return device_ == nullptr || device_->connected(); }
  bool isSimulated() const { return device_ != nullptr && device_->isSimulated(); }
  const Pose& q_device() const { return sample_.q_device; }
  void put(const Pose& q_device);
  /// Begins a new run: the object is back at the start and the device begins anew.
  void restart();
  /// The run is paused: what the device does now does not move the object, neither now nor when the run is resumed.
  void rest() {
    if (device_) device_->regrip();
  }
  /// Purpose of advance(), for the diagnostic of an exception that leaves it.
  static constexpr CatalogueText kWork = GLISSADE_TEXT("moving the object with the device");
  /// Releases the object for good because its device has failed, and returns the message for the user.
  Diagnostic giveUp(Diagnostic why);
  /// Advances time and the device. `guidance` also holds for sample().
  void advance(double dt, const OperatorFrame& frame, const StartTreeDistance& tree, const Guidance& guidance);
  /// State of the hand; nothing where nobody holds the object.
  std::optional<HandState> state() const {
    return held() ? std::make_optional(HandState{sample_.q_device, sample_.moves}) : std::nullopt;
  }
  /// q_device with Find_Nearest_Obstacle(q_device), computed once for each pose, and the guidance there, as the device
  /// renders it or as a haptic device would. There is no obstacle while the world is not prepared.
  const OperatorSample& sample();

 private:
  Box3 bounds_;
  Pose start_;
  CollisionWorldPtr world_;
  std::unique_ptr<CollisionQuery> query_;  ///< null until it is needed and the world is prepared
  std::unique_ptr<OperatorDevice> device_;
  OperatorSample sample_;
  bool nearestIsKnown_ = false;
  double objectRadius_;
  Guidance guidance_;
};

}  // namespace glissade
