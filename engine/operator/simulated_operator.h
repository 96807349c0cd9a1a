#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/geometry/se3_metric.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// Skill of a simulated operator. The numbers were fitted so that runs in lockstep come near the figures of paper 1 on
/// environment 1.
struct OperatorLevel {
  std::string_view id;
  double linearSpeed;    ///< largest speed, m/s
  double angularSpeed;   ///< largest angular speed, rad/s
  double delay;          ///< seconds between two sub-movements
  double aimError;       ///< standard deviation of the end of a sub-movement, m
  double aimErrorAngle;  ///< the same for its angle, rad
  double tremor;         ///< stationary standard deviation of the tremor, m
  double tremorAngle;    ///< stationary standard deviation of the tremor's angle, rad
  double hesitationsPerSecond;
};

const std::array<OperatorLevel, 3>& operatorLevels();
const OperatorLevel* findOperatorLevel(std::string_view id);

/// A simulated person with a 6D mouse who follows a plan of way points, so that interactive runs need no person:
/// minimum-jerk sub-movements (Flash and Hogan 1985) with a new aim error each, a reaction delay between them, tremor
/// (an Ornstein-Uhlenbeck process), hesitations (a Poisson process). Collisions do not block the hand. The operator
/// goes on to the next way point when the start tree has come near the current one, and keeps correcting the pose
/// around it until then. Where the tree does not slide on a surface, the operator goes on after some time, even if the
/// tree has only come into the neighbourhood. Where the tree lags behind, the operator waits, and after a while goes
/// back by one way point. Deterministic for a seed and the same sequence of calls.
class SimulatedOperator final : public OperatorDevice {
 public:
  /// `route`: way points in order; the operator stays at the last one.
  SimulatedOperator(const OperatorLevel& level, std::vector<Pose> route, const Se3Metric& metric, std::uint64_t seed);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override;
  bool isSimulated() const override { return true; }

  /// Index of the way point that the operator moves to.
  std::size_t target() const { return target_; }

 private:
  /// A minimum-jerk displacement by `translation` and the rotation vector `rotation`.
  struct SubMovement {
    Vector3 translation = Vector3::Zero();
    Vector3 rotation = Vector3::Zero();
    double duration = 0.0;
    double elapsed = 0.0;
  };

  bool seesTheTreeSlide(double dt, const OperatorView& view);
  void chooseTarget(double dt, const OperatorView& view);
  bool waitsForTheTree(double dt, const OperatorView& view);
  void beginSubMovement();
  Twist follow(double dt);
  Pose withTremor(double dt);

  OperatorLevel level_;
  std::vector<Pose> route_;
  Se3Metric metric_;
  RandomStream stream_;
  std::size_t target_ = 0;
  Pose aimed_;                 ///< pose of the hand without tremor
  std::optional<Pose> shown_;  ///< last returned pose; differs from q_device after another source has moved the object
  SubMovement movement_;
  double waited_ = 0.0;    ///< seconds of waiting for the tree at one place
  double lingered_ = 0.0;  ///< seconds at the present way point
  std::uint64_t contactNodes_ = 0;
  double sinceContact_ = 1.0;  ///< seconds since contact sampling added a node
  double rest_ = 0.0;          ///< seconds of delay or hesitation left
  Vector3 tremor_ = Vector3::Zero();
  Vector3 tremorAngle_ = Vector3::Zero();
};

}  // namespace glissade
