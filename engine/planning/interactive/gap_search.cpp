#include "engine/planning/interactive/gap_search.h"

#include <limits>

#include "engine/base/tolerances.h"
#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/automatic/tube_sampler.h"

namespace glissade {
namespace {

/// Longest extension, in radii of the object.
constexpr double kRange = 0.3;

/// Draws configurations of another sampler and makes them free where that is possible.
class FreedSampler final : public ConfigurationSampler {
 public:
  FreedSampler(std::unique_ptr<ConfigurationSampler> from, std::shared_ptr<ShownConfiguration> configuration,
               double clearance)
      : from_(std::move(from)), configuration_(std::move(configuration)), clearance_(clearance) {}

  Pose draw(const Box3& tree) override {
    const Pose q = from_->draw(tree);
    return configuration_->clearPose(q, clearance_).value_or(q);
  }

 private:
  std::unique_ptr<ConfigurationSampler> from_;
  std::shared_ptr<ShownConfiguration> configuration_;
  double clearance_;
};

std::unique_ptr<Planner> makeSearch(const Problem& problem, const Pose& from, const Pose& to, double deviation,
                                    std::uint64_t seed, const std::shared_ptr<ShownConfiguration>& configuration) {
  Problem part = problem;
  part.start = from;
  part.goal = to;
  const double radius = problem.world->objectRadius();
  RrtConnect::Options options;
  options.range = kRange * radius;
  options.slides = true;
  auto tube = std::make_unique<TubeSampler>(part, std::vector<Pose>{from, to}, deviation, seed);
  auto sampler = std::make_unique<FreedSampler>(std::move(tube), configuration, tolerance::kContactGap * radius);
  return std::make_unique<RrtConnect>(part, seed, options, std::move(sampler));
}

}  // namespace

GapSearch::GapSearch(const Problem& problem, const Pose& from, const Pose& to, double deviation, std::uint64_t seed,
                     std::shared_ptr<ErodedWorlds> worlds)
    : target_(to),
      configuration_(std::make_shared<ShownConfiguration>(problem, std::move(worlds), seed, 0)),
      search_(makeSearch(problem, from, to, deviation, seed, configuration_), std::numeric_limits<std::uint64_t>::max(),
              nullptr) {}

std::optional<std::vector<Pose>> GapSearch::step(PlannerHost& host) {
  if (search_.advance(host) != SubPlanner::State::Solved) return std::nullopt;
  return search_.planner().path()->configurations();
}

QueryCounts GapSearch::queries() const {
  QueryCounts sum = configuration_->counts();
  return sum += search_.planner().counts().queries;
}

}  // namespace glissade
