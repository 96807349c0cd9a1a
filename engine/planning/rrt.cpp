#include "engine/planning/rrt.h"

#include "engine/base/tolerances.h"
#include "engine/planning/goal_roots.h"

namespace glissade {
namespace {

constexpr double kGoalBias = 0.05;

}  // namespace

Rrt::Rrt(const Problem& problem, std::uint64_t seed, Limit limit)
    : TreePlanner(problem, problem.metric()),
      limit_(limit),
      goalStream_(seed, "goal bias"),
      randomShooter_(problem, seed) {
  goals_ = goalRoots(problem_, *query_);
  counts_.nodes = roadmap_.nodes().size();
}

bool Rrt::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    iterate(host);
    updateCounts();
    if (!path_ && limit_ == Limit::GlobalSamples &&
        static_cast<double>(counts_.randomConfigurations) >= host.parameters()[ParameterId::GlobalSamples]) {
      failure_ = Diagnostic{ErrorKind::LimitReached, "", "",
                            GLISSADE_TEXT("strategy G found no path within its limit of samples"),
                            GLISSADE_TEXT("Raise --global-samples, or use the strategy Layers (gts).")};
    }
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void Rrt::iterate(PlannerHost& host) {
  ++counts_.iterations;
  ++counts_.steps;
  ++counts_.randomConfigurations;
  const double draw = goalStream_.uniform();
  const bool towardsGoal = draw < kGoalBias && !goals_.empty();
  const auto which = static_cast<std::size_t>(draw / kGoalBias * static_cast<double>(goals_.size()));
  const Pose q = towardsGoal ? goals_[which] : randomShooter_.shoot();
  const auto reached = growTo(q, host);
  if (towardsGoal && reached) deliverWay(*reached, host);
}

std::optional<Rrt::Node> Rrt::growTo(const Pose& q, PlannerHost& host) {
  const auto near = roadmap_.nearest(roadmap_.componentOf(startRoot_), q);
  if (near.distance == 0.0) return near.index;
  const ExtensionRule rule{host.parameters()[ParameterId::GrowthStep], host.parameters()[ParameterId::ExtensionStep],
                           tolerance::kSameConfiguration * metric_.radius()};
  const Extension grown = extension(near.index, q, near.distance, rule, host);
  if (grown.progress == Progress::Trapped) return std::nullopt;
  const Node node = roadmap_.addChild(near.index, {grown.end, Author::Computer, TreeSide::Start});
  return grown.progress == Progress::Reached ? std::optional<Node>(node) : std::nullopt;
}

}  // namespace glissade
