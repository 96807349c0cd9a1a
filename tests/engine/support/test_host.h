#pragma once

#include <optional>

#include "engine/planning/planner.h"

namespace glissade {

/// A host with a fixed operator (or none) that ends the run after so many steps.
class TestHost final : public PlannerHost {
 public:
  explicit TestHost(const Problem& problem, std::uint64_t maxSteps = 20000)
      : values(problem.world->objectRadius()), stepsLeft(maxSteps) {}

  std::optional<OperatorSample> operatorSample() override { return sample; }
  const ParameterValues& parameters() const override { return values; }
  bool afterStep() override { return --stepsLeft > 0; }
  const StopToken& stopToken() const override { return stop; }
  SemanticEditsPtr semanticEdits() const override { return edits; }

  ParameterValues values;
  std::optional<OperatorSample> sample;
  StopToken stop;
  SemanticEditsPtr edits;
  std::uint64_t stepsLeft;
};

inline OperatorSample operatorAt(const Problem& problem, const Pose& q, std::uint64_t moves = 1) {
  OperatorSample sample;
  sample.q_device = q;
  sample.nearest = problem.world->makeQuery()->nearestObstacle(q);
  sample.moves = moves;
  return sample;
}

}  // namespace glissade
