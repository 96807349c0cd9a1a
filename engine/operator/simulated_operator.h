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

/// How well somebody steers. The numbers were fitted so that runs in lockstep come near the first
/// paper's figures on environment 1.
struct OperatorLevel {
  std::string_view id;
  double linearSpeed;    ///< m/s, at most
  double angularSpeed;   ///< rad/s, at most
  double delay;          ///< s, between two sub-movements
  double aimError;       ///< m, standard deviation of where a sub-movement ends
  double aimErrorAngle;  ///< rad
  double tremor;         ///< m, stationary standard deviation
  double tremorAngle;    ///< rad
  double hesitationsPerSecond;
};

const std::array<OperatorLevel, 3>& operatorLevels();
const OperatorLevel* findOperatorLevel(std::string_view id);

/// A person with a 6D mouse who follows a plan of way-points, so that interactive runs need no
/// person: minimum-jerk sub-movements (Flash and Hogan 1985) with a fresh aim error each, a reaction
/// delay between them, tremor (an Ornstein-Uhlenbeck process), hesitations (a Poisson process). He is
/// not blocked by collisions. He goes on to the next way-point when the start tree has come near the
/// current one, and keeps correcting around it until then. Where he does not see the tree slide on a
/// surface he loses patience, and goes on though the tree only came into the neighbourhood. He waits where the tree
/// lags behind him; after a while he goes back a way-point to fetch it. Deterministic for a seed and the same sequence
/// of calls.
class SimulatedOperator final : public OperatorDevice {
 public:
  /// `route` in the order in which to pass; he stays at the last one.
  SimulatedOperator(const OperatorLevel& level, std::vector<Pose> route, const Se3Metric& metric, std::uint64_t seed);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override;
  bool isSimulated() const override { return true; }

  /// Index of the way-point he is heading for.
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
  Pose aimed_;                 ///< where the hand is without tremor
  std::optional<Pose> shown_;  ///< what was returned last; differs from q_device after somebody put the object
  SubMovement movement_;
  double waited_ = 0.0;    ///< seconds of waiting for the tree at one place
  double lingered_ = 0.0;  ///< seconds at the way-point he is heading for
  std::uint64_t contactNodes_ = 0;
  double sinceContact_ = 1.0;  ///< seconds since contact sampling brought a node
  double rest_ = 0.0;          ///< seconds of delay or hesitation left
  Vector3 tremor_ = Vector3::Zero();
  Vector3 tremorAngle_ = Vector3::Zero();
};

}  // namespace glissade
