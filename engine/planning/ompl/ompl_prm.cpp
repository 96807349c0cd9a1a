#include "engine/planning/ompl/ompl_prm.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

namespace glissade {

namespace ob = ompl::base;

void OmplPrm::addRoots() {
  while (const ob::State* start = pis_.nextStart()) startM_.push_back(addMilestone(si_->cloneState(start)));
  const auto* goal = pdef_->getGoal()->as<ob::GoalSampleableRegion>();
  while (goal->maxSampleCount() > goalM_.size()) {
    const ob::State* state = pis_.nextGoal();
    if (state == nullptr) break;
    goalM_.push_back(addMilestone(si_->cloneState(state)));
  }
}

void OmplPrm::growPiece(const ob::PlannerTerminationCondition& ptc) {
  // An expansion weighs all nodes anew: worth it for a few bounces at once, after some growth.
  constexpr std::uint64_t kBatch = 50;
  constexpr int kBounces = 10;
  const std::uint64_t before = world_.draws;
  if (growDraws_ < 2 * (expandDraws_ + kBatch)) {
    growRoadmap(ptc);
    growDraws_ += world_.draws - before;
  } else {
    int bounces = 0;
    const ob::PlannerTerminationCondition enough([&] { return world_.ends() || bounces++ >= kBounces; });
    expandRoadmap(enough);
    expandDraws_ += world_.draws - before;
  }
}

ob::PlannerStatus OmplPrm::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  if (ptc) return ob::PlannerStatus::TIMEOUT;
  if (startM_.empty()) addRoots();
  if (startM_.empty()) return ob::PlannerStatus::INVALID_START;
  if (goalM_.empty()) return ob::PlannerStatus::INVALID_GOAL;
  growPiece(ptc);
  ob::PathPtr solution;
  bestCost_ = opt_->infiniteCost();
  if (!maybeConstructSolution(startM_, goalM_, solution)) return ob::PlannerStatus::TIMEOUT;
  pdef_->addSolutionPath(solution, false, 0.0, getName());
  return ob::PlannerStatus::EXACT_SOLUTION;
}

void OmplPrm::clear() {
  PRM::clear();
  growDraws_ = 0;
  expandDraws_ = 0;
}

void OmplPrm::getPlannerData(ob::PlannerData& data) const {
  PRM::getPlannerData(data);
  for (std::size_t vertex = 0; vertex < boost::num_vertices(g_); ++vertex) {
    data.addVertex(ob::PlannerDataVertex(stateProperty_[vertex]));
  }
}

}  // namespace glissade
