#include "engine/planning/automatic/shrink_repair.h"

#include <algorithm>
#include <limits>

#include "engine/planning/automatic/path_repair.h"
#include "engine/planning/goal_roots.h"

namespace glissade {
namespace {

/// The depth of each level relative to the first.
constexpr double kLevels[] = {1.0, 0.75, 0.5, 0.3, 0.12};

bool isFree(const Problem& problem) {
  const auto query = problem.world->makeQuery();
  return !query->collides(problem.start) && !goalRoots(problem, *query).empty() &&
         !query->collides(goalRoots(problem, *query).front());
}

}  // namespace

ShrinkRepair::ShrinkRepair(const Problem& problem, std::uint64_t seed, const Options& options,
                           std::shared_ptr<ErodedWorlds> worlds)
    : problem_(problem), seed_(seed), options_(options), worlds_(std::move(worlds)) {
  for (const double level : kLevels) depths_.push_back(level * options_.erosion);
  depths_.push_back(-options_.growth);
  depths_.push_back(0.0);
}

bool ShrinkRepair::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    step(host);
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void ShrinkRepair::step(PlannerHost& host) {
  if (!search_) startLevel();
  SharedRoadmap& roadmap = isLast() ? own_ : eroded_;
  roadmap.counts = counts_;
  const SubPlanner::State state = search_->step(host, roadmap);
  counts_ = roadmap.counts;
  if (state == SubPlanner::State::Solved) {
    endLevel();
  } else if (state == SubPlanner::State::Failed && level_ > 0 && halvings_ < options_.halvings) {
    halveGrowth();
  } else if (state == SubPlanner::State::Failed ||
             (level_ == 0 && queriesOf(counts_) - levelWork_ > options_.firstWork)) {
    failure_ = Diagnostic{ErrorKind::NoPath, "", "",
                          GLISSADE_TEXT("the path of the shrunk object could not be repaired for the full-size object"),
                          GLISSADE_TEXT("Start again with another seed.")};
  }
}

/// Starts the search of a level: everywhere for the first level, later about the way of the level before.
void ShrinkRepair::startLevel() {
  Problem part = problem_;
  part.world = worlds_->at(depths_[level_]);
  if (depths_[level_] < 0.0 && !isFree(part)) {  // the grown object does not fit at its ends
    ++level_;
    part.world = worlds_->at(depths_[level_]);
  }
  const std::uint64_t seed = RandomStream(seed_, "level " + std::to_string(level_)).bits();
  std::unique_ptr<Planner> search;
  if (level_ == 0) {
    search = std::make_unique<RrtConnect>(part, seed, options_.search, std::make_unique<UniformSampler>(part, seed));
  } else {
    const PathRepair::Options repair{worlds_->at(wayDepth_), wayDepth_ - depths_[level_], options_.search,
                                     options_.repairWork};
    search = std::make_unique<PathRepair>(part, seed, way_, repair);
  }
  search_ = std::make_unique<SubPlanner>(std::move(search), std::numeric_limits<std::uint64_t>::max(), nullptr);
  eroded_ = {};
  levelWork_ = queriesOf(counts_);
}

void ShrinkRepair::halveGrowth() {
  ++halvings_;
  depths_.insert(depths_.begin() + static_cast<std::ptrdiff_t>(level_), 0.5 * (wayDepth_ + depths_[level_]));
  search_.reset();
}

/// The goal "out" of a smaller object is nearer to the obstacles than that of the whole object.
void ShrinkRepair::endAtGoal() {
  const auto query = problem_.world->makeQuery();
  const std::vector<Pose> goals = goalRoots(problem_, *query);
  if (goals.empty()) return;
  const Se3Metric metric = problem_.metric();
  const Pose& goal = *std::min_element(goals.begin(), goals.end(), [&](const Pose& a, const Pose& b) {
    return metric.distance(way_.back(), a) < metric.distance(way_.back(), b);
  });
  if (way_.back() != goal) way_.push_back(goal);
}

void ShrinkRepair::endLevel() {
  const Path& path = *search_->planner().path();
  if (isLast()) {
    path_ = path;
    return;
  }
  way_ = path.configurations();
  endAtGoal();
  wayDepth_ = depths_[level_];
  search_.reset();
  ++level_;
}

}  // namespace glissade
