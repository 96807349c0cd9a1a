#include "engine/access/plan_access.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {
namespace {

Diagnostic interrupted() {
  return {ErrorKind::Interrupted, "", "", "the access of the hand was not checked to its end", "Start it again."};
}

ReachedMotion motionOf(const AssemblyStep& step, const AssembledProduct& product, std::vector<std::size_t> bodies,
                       const BodySet& there) {
  ReachedMotion motion{std::move(bodies), bodiesIn(there), {}, step.tool.kind, {}};
  if (!step.tool.turned.empty()) motion.bolt = product.indexOf(step.tool.turned);
  if (motion.bolt) std::erase(motion.others, *motion.bolt);
  const Pose back = step.path.empty() ? Pose::identity() : inverse(step.path.front().q);
  for (const PathPoint& point : step.path) motion.moved.push_back(point.q * back);
  if (motion.moved.empty()) motion.moved.push_back(Pose::identity());
  return motion;
}

/// What the plan has found of the tool counts too: it has also brought the tool on.
void noteTool(const StepTool& tool, const AssembledProduct& product, HandAnswer& hand) {
  if (tool.access != ToolAccess::Blocked || hand.access != HandAccess::Free) return;
  hand.access = HandAccess::Blocked;
  hand.share = 0.0;
  hand.bends.front() = std::nullopt;
  if (!tool.blockedBy.empty()) hand.blockedBy = product.indexOf(tool.blockedBy.front());
}

double clearanceAt(CollisionQuery& query, const Pose& X_WB) { return query.nearestObstacle(X_WB).distance; }

}  // namespace

std::size_t PlanAccess::reached() const {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [](const MotionAccess& step) { return step.isReachedAndSeen(); }));
}

Result<PlanAccess> planAccess(const AssembledProduct& product, const AssemblyPlan& plan, const Person& person,
                              const WorkWatch& watch) {
  AccessChecker checker(product.bodies, person);
  PlanAccess access{person, {}, checker.forearm()};
  BodySet there(product.bodies.size(), true);
  for (const AssemblyStep& step : plan.steps) {
    std::vector<std::size_t> bodies = bodiesOf(step, product);
    there = without(std::move(there), bodies);
    MotionAccess found = checker.of(motionOf(step, product, std::move(bodies), there), watch.stop);
    if (watch.stop.stopRequested()) return interrupted();
    noteTool(step.tool, product, found.hand);
    access.steps.push_back(std::move(found));
    watch.report(static_cast<double>(access.steps.size()) / static_cast<double>(plan.steps.size()));
  }
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
