#pragma once

#include <cstdint>
#include <vector>

#include "engine/operator/operator_input.h"

namespace glissade {

/// What an operator did, by planner step: the pose in force from that step on.
struct RecordedPose {
  std::uint64_t step = 0;
  Pose q_device;
};

/// Plays a recording back in lockstep: one call is one step, so that the planner sees the very poses
/// that it saw at the same steps.
class RecordedDevice final : public OperatorDevice {
 public:
  /// Ascending steps.
  explicit RecordedDevice(std::vector<RecordedPose> recording) : recording_(std::move(recording)) {}

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override;

 private:
  std::vector<RecordedPose> recording_;
  std::uint64_t step_ = 0;
  std::size_t next_ = 0;
};

}  // namespace glissade
