#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Everything from outside that shaped a run, by planner step: with scenario, planner and seed
/// enough to grow the same roadmap again, bit by bit.
struct RunLog {
  struct ParameterChange {
    std::uint64_t step = 0;  ///< steps done when it took effect
    ParameterId id = ParameterId::Alpha;
    double value = 0.0;
  };
  struct OperatorPose {
    std::uint64_t step = 0;  ///< steps done when the planner first saw it
    Pose q_device;
  };

  ParameterValues initialParameters{1.0};
  std::vector<ParameterChange> parameterChanges;
  std::vector<OperatorPose> operatorStream;
};

}  // namespace glissade
