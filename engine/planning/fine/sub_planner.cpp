#include "engine/planning/fine/sub_planner.h"

#include "engine/planning/contact/interaction_report.h"

namespace glissade {
namespace {

/// Forwards to the host of the whole planner, for one step.
class OneStep final : public PlannerHost {
 public:
  OneStep(PlannerHost& host, const SamplingRegion* region) : host_(host), region_(region) {}

  std::optional<OperatorSample> operatorSample() override {
    auto sample = host_.operatorSample();
    if (sample && region_ != nullptr && !region_->contains(sample->q_device.position)) return std::nullopt;
    return sample;
  }
  const ParameterValues& parameters() const override { return host_.parameters(); }
  bool afterStep() override { return false; }
  const StopToken& stopToken() const override { return host_.stopToken(); }
  SemanticEditsPtr semanticEdits() const override { return host_.semanticEdits(); }

 private:
  PlannerHost& host_;
  const SamplingRegion* region_;
};

}  // namespace

SubPlanner::State SubPlanner::step(PlannerHost& host, SharedRoadmap& roadmap) {
  const State state = advance(host);
  collect(roadmap);
  return state;
}

SubPlanner::State SubPlanner::advance(PlannerHost& host) {
  OneStep one(host, region_.get());
  const bool solved = planner_->solve(one);
  if (solved) return State::Solved;
  const bool spent = randomConfigurations() >= samples_ && !contactModeOf(*planner_);
  return planner_->failure() || spent ? State::Failed : State::Running;
}

void SubPlanner::complete(SharedRoadmap& roadmap) {
  planner_->completeRoadmap();
  collect(roadmap);
}

void SubPlanner::collect(SharedRoadmap& roadmap) {
  for (std::size_t i = nodeIn_.size(); i < planner_->nodes().size(); ++i) {
    nodeIn_.push_back(static_cast<std::uint32_t>(roadmap.nodes.size()));
    roadmap.nodes.push_back(planner_->nodes()[i]);
  }
  for (std::size_t i = edgeIn_.size(); i < planner_->edges().size(); ++i) {
    const RoadmapEdge& edge = planner_->edges()[i];
    edgeIn_.push_back(static_cast<std::uint32_t>(roadmap.edges.size()));
    roadmap.edges.push_back({nodeIn_[edge.from], nodeIn_[edge.to]});
  }
  for (; droppedTaken_ < planner_->droppedEdges().size(); ++droppedTaken_) {
    roadmap.droppedEdges.push_back(edgeIn_[planner_->droppedEdges()[droppedTaken_]]);
  }
  const PlannerCounts& now = planner_->counts();
  PlannerCounts& all = roadmap.counts;
  const auto add = [](std::uint64_t& sum, std::uint64_t value, std::uint64_t& before) {
    sum += value - before;
    before = value;
  };
  add(all.iterations, now.iterations, counted_.iterations);
  add(all.steps, now.steps, counted_.steps);
  add(all.randomConfigurations, now.randomConfigurations, counted_.randomConfigurations);
  add(all.operatorConfigurations, now.operatorConfigurations, counted_.operatorConfigurations);
  add(all.contactConfigurations, now.contactConfigurations, counted_.contactConfigurations);
  add(all.queries.collision, now.queries.collision, counted_.queries.collision);
  add(all.queries.distance, now.queries.distance, counted_.queries.distance);
  add(all.queries.motion, now.queries.motion, counted_.queries.motion);
  add(all.queries.pairs, now.queries.pairs, counted_.queries.pairs);
}

}  // namespace glissade
