#include "engine/access/plan_access.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/sequence/body_group.h"

namespace glissade {
namespace {

Diagnostic interrupted() {
  return {ErrorKind::Interrupted, "", "", GLISSADE_TEXT("hand access was not checked to the end"),
          GLISSADE_TEXT("Start it again.")};
}

ReachedMotion motionOf(const StepMotion& motion, const AssembledProduct& product, std::vector<std::size_t> bodies,
                       const BodySet& there) {
  ReachedMotion reached{std::move(bodies), bodiesIn(there), {}, motion.tool.kind, {}};
  if (!motion.tool.turned.empty()) reached.bolt = product.indexOf(motion.tool.turned);
  if (reached.bolt) std::erase(reached.others, *reached.bolt);
  const Pose back = motion.path.empty() ? Pose::identity() : inverse(motion.path.front().q);
  for (const PathPoint& point : motion.path) reached.moved.push_back(point.q * back);
  if (reached.moved.empty()) reached.moved.push_back(Pose::identity());
  return reached;
}

/// Takes over the plan's result for the tool, which also includes how the tool is brought on.
void noteTool(const StepTool& tool, const AssembledProduct& product, HandAnswer& hand) {
  if (tool.access != ToolAccess::Blocked || hand.access != HandAccess::Free) return;
  hand.access = HandAccess::Blocked;
  hand.share = 0.0;
  hand.bends.front() = std::nullopt;
  if (!tool.blockedBy.empty()) hand.blockedBy = product.indexOf(tool.blockedBy.front());
}

double clearanceAt(CollisionQuery& query, const Pose& X_WB) { return query.nearestObstacle(X_WB).distance; }

std::size_t stepsIn(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines) {
  std::size_t count = steps.size();
  for (const SubassemblyLine& line : lines) count += stepsIn(line.steps, line.lines);
  return count;
}

/// Tests the steps of a plan and of its groups, one after the other.
class PlanAsker {
 public:
  PlanAsker(const AssembledProduct& product, AccessChecker& checker, std::size_t count, const WorkWatch& watch)
      : product_(product), checker_(checker), count_(count), watch_(watch) {}

  /// After a stop, the result contains the steps tested before it.
  /// `up`: see AssemblyPlan::up.
  LineAccess ask(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines, const Vector3& up,
                 BodySet there) {
    LineAccess access;
    for (const AssemblyStep& step : steps) {
      StepAccess found = accessOf(step, up, there);
      if (watch_.stop.stopRequested()) return access;
      access.steps.push_back(std::move(found));
      watch_.report(static_cast<double>(++asked_) / static_cast<double>(count_));
    }
    for (const SubassemblyLine& line : lines)
      access.lines.push_back(ask(line.steps, line.lines, line.up, groupOf(line)));
    return access;
  }

 private:
  /// Takes the bodies of the step out of `there`.
  StepAccess accessOf(const AssemblyStep& step, const Vector3& up, BodySet& there) {
    std::optional<StepAccess> deciding;
    for (std::size_t i = 0; i < step.motions.size() && !watch_.stop.stopRequested(); ++i) {
      const StepMotion& motion = step.motions[i];
      std::vector<std::size_t> bodies = product_.indicesOf(motion.bodies());
      there = without(std::move(there), bodies);
      ReachedMotion reached = motionOf(motion, product_, std::move(bodies), there);
      reached.up = up;
      StepAccess found{checker_.of(reached, watch_.stop), i};
      noteTool(motion.tool, product_, found.hand);
      const bool decides =
          deciding && deciding->isReachedAndSeen() && (!found.isReachedAndSeen() || &motion == &step.opening());
      if (!deciding || decides) deciding = std::move(found);
    }
    return deciding.value_or(StepAccess());
  }

  BodySet groupOf(const SubassemblyLine& line) const {
    BodySet there(product_.bodies.size(), false);
    for (const std::size_t body : product_.indicesOf(line.bodies)) there[body] = true;
    return there;
  }

  const AssembledProduct& product_;
  AccessChecker& checker_;
  std::size_t count_;
  const WorkWatch& watch_;
  std::size_t asked_ = 0;
};

}  // namespace

std::size_t LineAccess::count() const {
  return std::accumulate(lines.begin(), lines.end(), steps.size(),
                         [](std::size_t sum, const LineAccess& line) { return sum + line.count(); });
}

std::size_t LineAccess::reached() const {
  const auto here =
      std::count_if(steps.begin(), steps.end(), [](const MotionAccess& step) { return step.isReachedAndSeen(); });
  return std::accumulate(lines.begin(), lines.end(), static_cast<std::size_t>(here),
                         [](std::size_t sum, const LineAccess& line) { return sum + line.reached(); });
}

Result<PlanAccess> planAccess(const AssembledProduct& product, const AssemblyPlan& plan, const Person& person,
                              const WorkWatch& watch) {
  AccessChecker checker(product.bodies, person);
  PlanAsker asker(product, checker, stepsIn(plan.steps, plan.lines), watch);
  const BodySet all(product.bodies.size(), true);
  PlanAccess access{asker.ask(plan.steps, plan.lines, plan.up, all), person, checker.forearm()};
  if (watch.stop.stopRequested()) return interrupted();
  return access;
}

Result<PathAccess> pathAccess(const std::vector<RigidBody>& obstacles, RigidBody object, const std::vector<Pose>& path,
                              const Person& person, const WorkWatch& watch) {
  PathAccess access;
  const auto query = CollisionWorld::build(obstacles, object.mesh)->makeQuery();
  std::vector<Pose> way = path;
  access.beginsAtEnd = clearanceAt(*query, path.back()) < clearanceAt(*query, path.front());
  if (access.beginsAtEnd) std::reverse(way.begin(), way.end());
  object.X_WB = access.X_WB = way.front();
  ReachedMotion motion;
  for (const Pose& q : way) motion.moved.push_back(q * inverse(way.front()));
  motion.bodies = {obstacles.size()};
  motion.others.resize(obstacles.size());
  std::iota(motion.others.begin(), motion.others.end(), std::size_t{0});
  std::vector<RigidBody> bodies = obstacles;
  bodies.push_back(std::move(object));
  AccessChecker checker(bodies, person);
  access.motion = checker.of(motion, watch.stop);
  access.forearm = checker.forearm();
  if (watch.stop.stopRequested()) return interrupted();
  return access;
}

}  // namespace glissade
