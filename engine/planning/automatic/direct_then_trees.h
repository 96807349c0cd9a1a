#pragma once

#include "engine/planning/automatic/direct_motions.h"
#include "engine/planning/automatic/rrt_connect.h"

namespace glissade {

/// Direct motions first, then two trees: what is left of a path after a screw motion is simple, mostly.
class DirectThenTrees final : public Planner {
 public:
  DirectThenTrees(const Problem& problem, std::uint64_t seed, const RrtConnect::Options& options)
      : direct_(problem), trees_(problem, seed, options, std::make_unique<UniformSampler>(problem, seed)) {}

  bool solve(PlannerHost& host) override {
    if (current_ == &direct_) {
      if (direct_.solve(host)) return true;
      if (!direct_.failure()) return false;
      current_ = &trees_;
      if (host.stopToken().stopRequested()) return false;
    }
    return trees_.solve(host);
  }
  void completeRoadmap() override { current_->completeRoadmap(); }

  const std::vector<RoadmapNode>& nodes() const override { return current_->nodes(); }
  const std::vector<RoadmapEdge>& edges() const override { return current_->edges(); }
  const std::vector<std::uint32_t>& droppedEdges() const override { return current_->droppedEdges(); }
  const PlannerCounts& counts() const override { return current_->counts(); }
  const Path* path() const override { return current_->path(); }
  std::optional<Diagnostic> failure() const override { return current_->failure(); }

 private:
  DirectMotions direct_;
  RrtConnect trees_;
  Planner* current_ = &direct_;
};

}  // namespace glissade
