#pragma once

#include <map>

#include "engine/base/message.h"
#include "engine/planning/coarse/coarse_plan_report.h"
#include "engine/planning/coarse/coarse_planning.h"
#include "engine/planning/contact/interaction_report.h"
#include "engine/planning/fine/semantic_planner.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// Coarse planning on topology and semantics, then fine planning step by step.
///
/// S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, "Multi-layer path planning control for the
/// simulation of manipulation tasks: Involving semantics and topology", RCIM 57 (2019), section 4 and
/// figure 7. Deviations: a straight motion that is blocked is handed to the planners of the first
/// rule; every delivered path is certified. Beyond the paper, where the rules say so: coarse and fine
/// planning in a loop, solved steps kept, with a search of the whole workspace taking turns as a last
/// resort; passages crossed in the configuration that fits best; edits of the semantics while it runs.
class MultiLayerPlanner final : public Planner, public ReportsInteraction, public ReportsCoarsePlan {
 public:
  MultiLayerPlanner(const Problem& problem, std::uint64_t seed, StrategyRules rules);
  ~MultiLayerPlanner() override;

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes; }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges; }
  const PlannerCounts& counts() const override { return roadmap_.counts; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  Author authority() const override { return authority_; }
  bool inContactMode() const override;
  std::optional<Diagnostic> failure() const override { return failure_; }
  CoarsePlanPtr coarsePlan() const override { return published_; }

 private:
  enum class Phase { Prepare, Coarse, Milestones, Fine, Deliver, LastResort };

  void advance(PlannerHost& host);
  void prepare(PlannerHost& host);
  void noticeEdits(PlannerHost& host);
  void planCoarsely();
  void drawMilestone(PlannerHost& host);
  void crossPlace(PlannerHost& host);
  void startLocalPlanner(PlannerHost& host);
  void show(const FineChoice& choice);
  void stepSolved();
  void stepFailed(PlannerHost& host, const Message& reason);
  void searchWorkspace(PlannerHost& host);
  TopologicalStep& wholeWorkspaceStep();
  void deliver(PlannerHost& host);
  void fail(const Message& reason, const Message& advice);
  void publish();

  TopologicalStep& current() { return plan_.steps[at_]; }
  int borderBefore() const { return at_ == 0 ? -1 : plan_.steps[at_ - 1].border; }
  std::uint64_t seedOf(const std::string& use) const;
  std::uint64_t stepBudget(const ParameterValues& parameters) const;

  Problem problem_;
  std::uint64_t seed_;
  StrategyRules rules_;
  std::unique_ptr<CollisionQuery> query_;
  PlannerRegistry locals_;

  SceneKnowledgePtr knowledge_;
  SemanticEditsPtr edits_;
  std::optional<CoarsePlanning> coarse_;  ///< exists once the knowledge is there
  std::optional<Pose> goal_;

  Phase phase_ = Phase::Prepare;
  CoarsePlan plan_;
  CoarsePlanPtr published_;
  std::size_t at_ = 0;  ///< step whose milestone is drawn, or that is crossed
  LearntCosts learnt_;
  std::optional<MilestoneSampler> milestoneSampler_;
  std::uint64_t milestoneDraws_ = 0;
  FineChoice choice_;
  std::unique_ptr<SubPlanner> local_;
  /// A solution of a step, and its planners.
  struct Crossing {
    FineChoice choice;
    std::vector<PathPoint> points;
  };
  std::map<std::array<int, 3>, Crossing> crossed_;  ///< key: the place and the borders at both ends
  std::unique_ptr<SubPlanner> whole_;               ///< the search of the whole workspace
  std::uint64_t turn_ = 0;                          ///< random configurations until the turn of the loop

  Author authority_ = Author::Computer;
  SharedRoadmap roadmap_;
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
