#include "engine/sequence/searched_removal.h"

#include "engine/base/random_stream.h"
#include "engine/planning/automatic/automatic_planner.h"
#include "engine/planning/threaded_planner.h"

namespace glissade {
namespace {

/// Lets a planner work for so many steps.
class BudgetHost final : public PlannerHost {
 public:
  BudgetHost(const ParameterValues& parameters, std::uint64_t steps, const StopToken& stop)
      : parameters_(parameters), left_(steps), stop_(stop) {}

  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return parameters_; }
  bool afterStep() override { return --left_ > 0 && !stop_.stopRequested(); }
  const StopToken& stopToken() const override { return stop_; }

 private:
  ParameterValues parameters_;
  std::uint64_t left_;
  const StopToken& stop_;
};

/// Room to leave on every side.
Box3 roomAbout(Box3 box, const MovingObject& object) {
  box.extend(object.X_WB.position);
  const Vector3 margin = Vector3::Constant(3.0 * object.radius);
  return {box.min() - margin, box.max() + margin};
}

std::unique_ptr<Planner> plannerOf(const Problem& problem, std::uint64_t seed) {
  const auto make = [seed](const Problem& rest) -> std::unique_ptr<Planner> {
    return std::make_unique<AutomaticPlanner>(rest, seed, 1);
  };
  if (problem.world->threads().empty()) return make(problem);
  return std::make_unique<ThreadedPlanner>(problem, make, std::make_unique<MarkedThreadWays>(problem.world));
}

}  // namespace

RemovalAnswer SearchedRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, std::uint64_t steps,
                                          const StopToken& stop) const {
  const MovingObject& object = worlds_.object(group);
  const MotionWorld motion = worlds_.world(group, present);
  Problem problem{motion.world, object.X_WB, GoalOut{}, roomAbout(motion.world->obstaclesBox(), object), nullptr, {}};
  if (!motion.world->makeQuery()->clearAbove(object.X_WB, object.required)) return Refused{};
  const auto planner = plannerOf(problem, seedOf(group, present, steps));
  BudgetHost host(worlds_.parameters(group), steps, stop);
  if (planner->solve(host)) {
    Path path = *planner->path();
    nameByProduct(path.certificate, motion.bodies);
    return Removed{std::move(path), "auto: " + memberOf(*planner), fits_.fitsOf(group, present)};
  }
  return Refused{{}, stop.stopRequested()};
}

/// Of its own for each question, so that it does not matter which were asked before.
std::uint64_t SearchedRemoval::seedOf(const BodyGroup& group, const BodySet& present, std::uint64_t steps) const {
  std::string question;
  for (const std::size_t body : group) question += product_.bodies[body].id + "/";
  question += std::to_string(bodiesIn(present).size()) + "/" + std::to_string(steps);
  return RandomStream(seed_, question).bits();
}

}  // namespace glissade
