#pragma once

#include <optional>
#include <vector>

#include "engine/planning/automatic/automatic_planner.h"
#include "engine/planning/contact/interactive_contact_birrt.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// Algorithm 1 of paper 1 whose third tree is the way of the hand (OperatorUse::GuideContactAndTrail). At alpha = 1 the
/// computer alone finishes the run: the planners of the strategy "auto" plan from the start to the way of the hand, and
/// from there to the goal, whichever is missing. The whole problem takes turns with these, because a way may lead
/// nowhere. Below alpha = 1 the hand and Algorithm 1 go on.
class HandPlanner final : public Planner {
 public:
  HandPlanner(const Problem& problem, std::uint64_t seed);
  ~HandPlanner() override;

  bool solve(PlannerHost& host) override;
  void completeRoadmap() override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes; }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges; }
  const PlannerCounts& counts() const override { return roadmap_.counts; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }
  const Planner* inner() const override;

 private:
  struct Rest;

  void stepOfHand(PlannerHost& host);
  void stepOfComputer(PlannerHost& host);
  void beginRest(PlannerHost& host);
  void deliverRest(PlannerHost& host);
  void updateCounts();

  Problem problem_;
  std::uint64_t seed_;
  std::unique_ptr<CollisionQuery> query_;
  InteractiveContactBirrt* hand_;  ///< owned by handSteps_
  SubPlanner handSteps_;
  std::unique_ptr<Rest> rest_;  ///< null while the hand and Algorithm 1 plan
  SharedRoadmap roadmap_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
