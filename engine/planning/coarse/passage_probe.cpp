#include "engine/planning/coarse/passage_probe.h"

#include "engine/planning/contact/interactive_contact_birrt.h"

namespace glissade {
namespace {

constexpr std::uint64_t kMostConfigurations = 2000;
constexpr std::uint64_t kSeed = 1;

/// Lets a planner run for a given number of random configurations.
class ProbeHost final : public PlannerHost {
 public:
  ProbeHost(const Planner& planner, double objectRadius, const StopToken& stop)
      : planner_(planner), parameters_(objectRadius), stop_(stop) {}

  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return parameters_; }
  bool afterStep() override {
    return planner_.counts().randomConfigurations < kMostConfigurations && !stop_.stopRequested();
  }
  const StopToken& stopToken() const override { return stop_; }

 private:
  const Planner& planner_;
  ParameterValues parameters_;
  StopToken stop_;
};

/// The cells of the passage and of its borders.
SamplingRegionPtr regionOf(const TopologicalMap& map, std::size_t place) {
  std::vector<std::size_t> cells = map.places[place].cells;
  for (const Border& border : map.borders) {
    if (border.placeA == static_cast<int>(place) || border.placeB == static_cast<int>(place)) {
      cells = unionOf(cells, border.cells);
    }
  }
  return std::make_shared<const SamplingRegion>(map.grid, std::move(cells));
}

}  // namespace

ProbeResult probePassage(const EnvironmentModel& environment, std::size_t place, const CollisionWorldPtr& world,
                         const Box3& bounds, const Pose& inside, const StopToken& stop) {
  const Place& passage = environment.map.places[place];
  const double radius = 1.02 * world->objectRadius();
  Problem problem;
  problem.world = world;
  problem.bounds = bounds;
  problem.region = regionOf(environment.map, place);
  problem.start = inside;
  problem.start.position[passage.axis] = passage.box.min()[passage.axis] - radius;
  Pose goal = inside;
  goal.position[passage.axis] = passage.box.max()[passage.axis] + radius;
  problem.goal = goal;
  const auto query = world->makeQuery();
  if (query->collides(problem.start) || query->collides(goal)) return {};
  InteractiveContactBirrt planner(problem, kSeed, OperatorUse::None);
  ProbeHost host(planner, world->objectRadius(), stop);
  const bool passes = planner.solve(host);
  return {passes, planner.counts().randomConfigurations};
}

}  // namespace glissade
