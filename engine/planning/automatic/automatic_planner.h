#pragma once

#include <memory>
#include <thread>
#include <vector>

#include "engine/base/thread_team.h"
#include "engine/planning/automatic/member.h"
#include "engine/planning/automatic/portfolio.h"
#include "engine/planning/automatic/portfolio_partner.h"
#include "engine/planning/automatic/portfolio_report.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// The result of one member's round.
struct SlotResult {
  SubPlanner::State state = SubPlanner::State::Running;
  std::uint64_t work = 0;     ///< queries and steps, by what they cost; never seconds
  std::uint64_t turns = 0;    ///< of one step
  bool madeProgress = false;  ///< it has done another of its stages
};

/// Lets one life of a member have turns until it has spent the quantum, has ended, or is stopped;
/// at least one. Its growth is not collected. On any thread: of the host it needs what may be asked by
/// several at once.
SlotResult runSlot(SubPlanner& life, PlannerHost& host, std::uint64_t quantum);

/// The host of a round, for all of its slots at once: what could change meanwhile is as it was when the
/// round began. Made on the planner's thread.
class RoundHost final : public PlannerHost {
 public:
  explicit RoundHost(PlannerHost& host) : host_(host), operator_(host.operatorSample()), edits_(host.semanticEdits()) {}

  std::optional<OperatorSample> operatorSample() override { return operator_; }
  const ParameterValues& parameters() const override { return host_.parameters(); }
  bool afterStep() override { return false; }
  const StopToken& stopToken() const override { return host_.stopToken(); }
  SemanticEditsPtr semanticEdits() const override { return edits_; }

 private:
  PlannerHost& host_;
  std::optional<OperatorSample> operator_;
  SemanticEditsPtr edits_;
};

/// A portfolio of planners that needs no settings. Each member has turns of one step. Turns are dealt by work
/// (collision and distance queries, never seconds), so that a seed gives one roadmap on every machine. A member
/// restarts when its life is over, and the first certified path ends the run.
///
/// With several slots (parameter `lanes` in files) the planner works in rounds: as many lives as there are slots run
/// side by side, each for the same quantum of work. The portfolio decides by the shares whether they belong to
/// different members or to one. Their roadmaps and costs are added up in the order in which the portfolio dealt the
/// turns. The result depends on the seed and the slots, not on the number of threads nor on their speed. Of several
/// paths found in a round, the one that took the least work counts. Only the calling thread asks the host, once for
/// every turn, after the round.
///
/// The roadmap is the union of the members' roadmaps, in the order in which they were collected, including lives that
/// are over. A member that plans with a modified object contributes only the nodes and edges that hold for the given
/// object. Counts are summed over all members and lives.
///
/// A partner takes turns of one step between the rounds. Its reports replace those of this planner.
class AutomaticPlanner final : public Planner, public ReportsMembers {
 public:
  /// At most `mostThreads` threads, including the calling one, run the slots. `partner`: null for none.
  AutomaticPlanner(const Problem& problem, std::uint64_t seed,
                   std::size_t mostThreads = std::thread::hardware_concurrency(),
                   std::unique_ptr<PortfolioPartner> partner = nullptr);
  ~AutomaticPlanner() override;

  bool solve(PlannerHost& host) override;
  void completeRoadmap() override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes; }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }
  const Planner* inner() const override { return partner_ ? &partner_->planner().planner() : nullptr; }
  std::string member() const override;
  double helpersCpuSeconds() const override { return team_ ? team_->helpersCpuSeconds() : 0.0; }

 private:
  /// One life of a member, or an empty place for one.
  struct Life {
    std::unique_ptr<SubPlanner> planner;  ///< null before its first turn
    std::uint64_t number = 0;             ///< number of the life among the member's lives, from 1; 0: not begun
    std::uint64_t work = 0;
  };
  /// The turn of one life in a round.
  struct Part {
    std::size_t member;
    std::size_t index;  ///< index among the member's lives
    SlotResult result;
  };

  std::vector<Member> membersOf(const Problem& problem) const;
  void round(PlannerHost& host);
  void runPartner(PlannerHost& host);
  void reportToPartner(std::uint64_t quantum, std::size_t edgesBefore);
  void assignSlots(std::size_t slots, std::uint64_t quantum);
  void runParts(PlannerHost& host, std::size_t slots, std::uint64_t quantum);
  void work(Part& part, PlannerHost& host, std::uint64_t quantum);
  void settle(const Part& part);
  void deliver();
  void updateCounts();
  Life& lifeOf(const Part& part) { return lives_[part.member][part.index]; }
  std::uint64_t seedOf(std::size_t member, std::uint64_t life) const;

  std::uint64_t seed_;
  std::size_t mostThreads_;
  Se3Metric metric_;
  std::unique_ptr<PortfolioPartner> partner_;  ///< null: none
  std::vector<Member> members_;
  Portfolio portfolio_;
  std::vector<std::vector<Life>> lives_;   ///< one entry per member: its lives that had turns at the same time
  std::vector<std::uint64_t> livesBegun_;  ///< one entry per member
  std::uint64_t quantum_;                  ///< work of a slot in the next round
  std::vector<Part> parts_;                ///< parts of the last round, in the order dealt
  std::uint64_t owedTurns_ = 0;            ///< turns of the last round that the host has not counted yet
  std::unique_ptr<ThreadTeam> team_;       ///< created for the first round with several slots
  SharedRoadmap roadmap_;
  PlannerCounts counts_;  ///< counts without the steps of the owed turns
  std::optional<Path> path_;
  std::string solver_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
