#include "engine/planning/automatic/automatic_planner.h"

#include <limits>

#include "engine/planning/goal_roots.h"

namespace glissade {
namespace {

std::vector<Contender> contendersOf(const std::vector<Member>& members) {
  std::vector<Contender> contenders;
  for (const Member& member : members) contenders.push_back(member.contender);
  return contenders;
}

/// What the members do, in quarters of a yes/no query. An iteration looks for neighbours; a draw that
/// is discarded at once costs next to nothing, so that steps do not count but for one a turn.
constexpr std::uint64_t kCollisionWork = 4;
constexpr std::uint64_t kDistanceWork = 16;
constexpr std::uint64_t kMotionWork = 80;
constexpr std::uint64_t kIterationWork = 8;
constexpr std::uint64_t kTurnWork = 1;

std::uint64_t workOf(const PlannerCounts& counts) {
  return kCollisionWork * counts.queries.collision + kDistanceWork * counts.queries.distance +
         kMotionWork * counts.queries.motion + kIterationWork * counts.iterations;
}

}  // namespace

AutomaticPlanner::AutomaticPlanner(const Problem& problem, std::uint64_t seed)
    : seed_(seed), members_(makeMembers(problem)), portfolio_(contendersOf(members_)), lives_(members_.size()) {
  roadmap_.nodes.push_back({problem.start, Author::Computer, TreeSide::Start});
  updateCounts();
  const auto query = problem.world->makeQuery();
  if (goalRoots(problem, *query).empty()) {
    failure_ = Diagnostic{ErrorKind::NoPath, "", "", "there is no configuration outside within the bounds",
                          "Widen the workspace."};
  }
}

AutomaticPlanner::~AutomaticPlanner() = default;

std::string AutomaticPlanner::member() const {
  return active_ == Portfolio::kNobody ? std::string() : members_[active_].name;
}

bool AutomaticPlanner::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    turn(host);
    updateCounts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void AutomaticPlanner::turn(PlannerHost& host) {
  active_ = portfolio_.next();
  std::unique_ptr<SubPlanner>& life = lives_[active_];
  if (!life) {
    life = std::make_unique<SubPlanner>(members_[active_].make(seedOf(active_)),
                                        std::numeric_limits<std::uint64_t>::max(), nullptr);
  }
  const std::uint64_t before = workOf(roadmap_.counts);
  const std::size_t stagesBefore = life->planner().stagesDone();
  const SubPlanner::State state = life->step(host, roadmap_);
  portfolio_.charge(active_, workOf(roadmap_.counts) - before + kTurnWork);
  if (life->planner().stagesDone() > stagesBefore) portfolio_.encourage(active_);
  if (state == SubPlanner::State::Solved) {
    path_ = *life->planner().path();
  } else if (state == SubPlanner::State::Failed && members_[active_].contender.restart == Restart::Never) {
    const auto reason = life->planner().failure();
    portfolio_.retire(active_);
    life->complete(roadmap_);
    life.reset();
    if (portfolio_.next() == Portfolio::kNobody) failure_ = reason;
  } else if (state == SubPlanner::State::Failed || portfolio_.lifeIsOver(active_)) {
    portfolio_.restart(active_);
    life->complete(roadmap_);
    life.reset();
  }
}

void AutomaticPlanner::completeRoadmap() {
  for (const auto& life : lives_) {
    if (life) life->complete(roadmap_);
  }
  updateCounts();
}

void AutomaticPlanner::updateCounts() {
  PlannerCounts& counts = roadmap_.counts;
  counts.nodes = roadmap_.nodes.size();
  counts.droppedEdges = roadmap_.droppedEdges.size();
  counts.edges = 2 * (roadmap_.edges.size() - roadmap_.droppedEdges.size());
}

/// Of the present life of a member.
std::uint64_t AutomaticPlanner::seedOf(std::size_t member) const {
  return RandomStream(seed_, members_[member].name + " life " + std::to_string(portfolio_.life(member))).bits();
}

}  // namespace glissade
