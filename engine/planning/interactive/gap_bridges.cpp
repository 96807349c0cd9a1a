#include "engine/planning/interactive/gap_bridges.h"

#include <algorithm>
#include <cmath>

#include "engine/planning/automatic/portfolio.h"

namespace glissade {
namespace {

constexpr std::uint64_t kFirstSteps = 100;
/// Deviation of the tube, in the distance that it bridges.
constexpr double kTubeDeviation = 0.25;

}  // namespace

GapBridges::GapBridges(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds)
    : problem_(problem), metric_(problem.metric()), stream_(seed, "gap bridges"), worlds_(std::move(worlds)) {}

GapBridges::State GapBridges::step(const RoadmapGraph& roadmap, RoadmapGraph::ComponentId tree, const FollowedWay& way,
                                   PlannerHost& host) {
  const auto reached = [&] {
    return way.same(roadmap.nodes()[roadmap.nearest(tree, search_->target()).index].q, search_->target());
  };
  if (!search_ || search_->steps() >= kFirstSteps * lubyTerm(inVain_) || reached()) begin(roadmap, tree, way);
  if (!search_) return State::NothingToSearch;
  auto found = search_->step(host);
  if (!found) return State::Searching;
  bridge_.poses = std::move(*found);
  inVain_ = 0;
  end();
  return State::Found;
}

void GapBridges::begin(const RoadmapGraph& roadmap, RoadmapGraph::ComponentId tree, const FollowedWay& way) {
  end();
  ++inVain_;
  const std::vector<Pose> targets = way.missing();
  if (targets.empty()) return;
  // The latest ones more often: that is where the hand waits.
  const double late = std::sqrt(stream_.uniform());
  const Pose& target = targets[static_cast<std::size_t>(late * static_cast<double>(targets.size()))];
  const auto near = roadmap.nearest(tree, target);
  const Pose& from = roadmap.nodes()[near.index].q;
  if (way.same(from, target)) return;
  bridge_ = {near.index, {}};
  const double deviation = std::max(way.recorder().spread(), kTubeDeviation * near.distance);
  search_.emplace(problem_, from, target, deviation, stream_.bits(), worlds_);
}

void GapBridges::end() {
  if (!search_) return;
  past_ += search_->queries();
  search_.reset();
}

QueryCounts GapBridges::queries() const {
  QueryCounts sum = past_;
  if (search_) sum += search_->queries();
  return sum;
}

}  // namespace glissade
