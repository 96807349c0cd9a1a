#pragma once

#include <memory>
#include <vector>

#include "engine/planning/automatic/member.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// A portfolio of planners that needs no settings: each member has turns of one step, dealt out by
/// work (collision and distance queries, never seconds, so that a seed gives one roadmap on every
/// machine), starts afresh when a life of it is over, and the first certified path ends the run.
///
/// The roadmap is that of all members, in the order in which it grew, also of lives that are over; of
/// members that plan with another object than the given one, only what holds for the given one.
/// Counts are summed over all members and lives.
class AutomaticPlanner final : public Planner {
 public:
  AutomaticPlanner(const Problem& problem, std::uint64_t seed);
  ~AutomaticPlanner() override;

  bool solve(PlannerHost& host) override;
  void completeRoadmap() override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes; }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges; }
  const PlannerCounts& counts() const override { return roadmap_.counts; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  Author authority() const override { return Author::Computer; }
  bool inContactMode() const override { return false; }
  std::optional<Diagnostic> failure() const override { return failure_; }
  std::string member() const override;

 private:
  void turn(PlannerHost& host);
  void updateCounts();
  std::uint64_t seedOf(std::size_t member) const;

  std::uint64_t seed_;
  std::vector<Member> members_;
  Portfolio portfolio_;
  std::vector<std::unique_ptr<SubPlanner>> lives_;  ///< per member; null before a life
  std::size_t active_ = Portfolio::kNobody;         ///< whose turn it was last
  SharedRoadmap roadmap_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
