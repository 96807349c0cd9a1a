#pragma once

#include "engine/planning/random_shooter.h"
#include "engine/planning/tree_planner.h"

namespace glissade {

/// One tree from the start (S. M. LaValle, "Rapidly-exploring random trees", 1998), as in strategy G of paper 2
/// (section 6.1) and as its local planner. Deviations: an extension goes straight up to the first obstacle instead of
/// one fixed step, and ends off the obstacle, as in our BiRRT; one draw in twenty is the goal (LaValle and Kuffner
/// 2001); the delivered path is certified.
class Rrt final : public TreePlanner {
 public:
  /// Strategy G gives up at the parameter `global_samples`; a local planner goes on for ever.
  enum class Limit { None, GlobalSamples };

  Rrt(const Problem& problem, std::uint64_t seed, Limit limit = Limit::None);

  bool solve(PlannerHost& host) override;

  std::optional<Diagnostic> failure() const override { return failure_; }

 private:
  void iterate(PlannerHost& host);
  /// The node at q, if the tree reached it.
  std::optional<Node> growTo(const Pose& q, PlannerHost& host);

  Limit limit_;
  RandomStream goalStream_;
  RandomShooter randomShooter_;
  std::vector<Pose> goals_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
