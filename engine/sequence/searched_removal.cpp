#include "engine/sequence/searched_removal.h"

#include "engine/base/random_stream.h"
#include "engine/planning/automatic/automatic_planner.h"
#include "engine/planning/automatic/straight_end.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/planning/threaded_planner.h"

namespace glissade {
namespace {

/// Number of attempts to shorten a path.
constexpr int kShortcuts = 100;
/// Work of a planner step, in pairs of the kernel.
constexpr std::uint64_t kStepWork = 50;

/// Stops a planner after each step.
class StepHost final : public PlannerHost {
 public:
  StepHost(const ParameterValues& parameters, const StopToken& stop) : parameters_(parameters), stop_(stop) {}

  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return parameters_; }
  bool afterStep() override { return false; }
  const StopToken& stopToken() const override { return stop_; }

 private:
  ParameterValues parameters_;
  const StopToken& stop_;
};

/// Work of a planner: pairs that the kernel has examined, and steps, which search neighbours.
std::uint64_t workOf(const PlannerCounts& counts) { return counts.queries.pairs + kStepWork * counts.steps; }

/// Runs step after step until the planner has a path, fails or has done `work`; true if it has a path.
bool solveWithin(Planner& planner, PlannerHost& host, std::uint64_t work) {
  while (!planner.solve(host)) {
    const bool isOver = planner.failure() || host.stopToken().stopRequested();
    if (isOver || workOf(planner.counts()) >= work) return false;
  }
  return true;
}

/// The box with the room that the object needs to leave on every side.
Box3 roomAbout(Box3 box, const MovingObject& object) {
  box.extend(object.X_WB.position);
  const Vector3 margin = Vector3::Constant(3.0 * object.radius);
  return {box.min() - margin, box.max() + margin};
}

/// Shortens the random path: straight out as soon as that is free, and without detours. A path out of a thread is kept.
Path smoothed(const Path& path, const Problem& problem, const ParameterValues& parameters, const StopToken& stop) {
  if (!problem.world->threads().empty()) return path;
  const Path straight = withStraightEnd(path, problem, parameters, stop);
  return withShortcuts(straight, problem, parameters, 0, kShortcuts, {stop});
}

std::unique_ptr<Planner> plannerOf(const Problem& problem, std::uint64_t seed) {
  const auto make = [seed](const Problem& rest) -> std::unique_ptr<Planner> {
    return std::make_unique<AutomaticPlanner>(rest, seed, 1);
  };
  if (problem.world->threads().empty()) return make(problem);
  return std::make_unique<ThreadedPlanner>(problem, make, std::make_unique<MarkedThreadWays>(problem.world));
}

}  // namespace

RemovalAnswer SearchedRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, std::uint64_t work,
                                          const StopToken& stop) const {
  return tryRemoval(group, present, worlds_.object(group).X_WB, work, stop);
}

RemovalAnswer SearchedRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, const Pose& start,
                                          std::uint64_t work, const StopToken& stop) const {
  const MovingObject& object = worlds_.object(group);
  const MotionWorld motion = worlds_.world(group, present);
  Problem problem{motion.world, start, GoalOut{}, roomAbout(motion.world->obstaclesBox(), object), nullptr, {}};
  if (!motion.world->makeQuery()->clearAbove(start, object.required)) return Refused{};
  const auto planner = plannerOf(problem, seedOf(group, present, work));
  StepHost host(worlds_.parameters(group), stop);
  if (solveWithin(*planner, host, work)) {
    Path path = smoothed(*planner->path(), problem, worlds_.parameters(group), stop);
    nameByProduct(path.certificate, motion.bodies);
    return Removed{std::move(path), "auto: " + memberOf(*planner), fits_.fitsOf(group, present)};
  }
  return Refused{{}, stop.stopRequested()};
}

/// A seed for each question, so that the answer does not depend on earlier questions.
std::uint64_t SearchedRemoval::seedOf(const BodyGroup& group, const BodySet& present, std::uint64_t work) const {
  std::string question;
  for (const std::size_t body : group) question += product_.bodies[body].id.text() + "/";
  question += std::to_string(bodiesIn(present).size()) + "/" + std::to_string(work);
  return RandomStream(seed_, question).bits();
}

}  // namespace glissade
