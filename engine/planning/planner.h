#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/parameters.h"
#include "engine/base/stop_token.h"
#include "engine/planning/operator_sample.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// Cost of a run so far. "Random configurations" are the papers' measure: every configuration that a sampler drew, kept
/// or not.
struct PlannerCounts {
  std::uint64_t iterations = 0;  ///< passes of the paper's loop (Algorithm 1, lines 1-15)
  std::uint64_t steps = 0;       ///< configurations handed to Add_Tree; a step is the tick of the lockstep clock
  std::uint64_t randomConfigurations = 0;
  std::uint64_t operatorConfigurations = 0;
  std::uint64_t contactConfigurations = 0;
  std::uint64_t nodes = 0;
  std::uint64_t edges = 0;          ///< edges in both directions, as in the papers
  std::uint64_t droppedEdges = 0;   ///< edges removed because a candidate path failed its certificate there
  std::uint64_t rejectedPaths = 0;  ///< whole paths that failed their certificate (OMPL's planners)
  QueryCounts queries;
};

/// Services that a running planner needs from its caller. Called on the planner's thread.
class PlannerHost {
 public:
  virtual ~PlannerHost() = default;

  /// The operator's latest sample; nothing where there is no operator, so that the computer has all authority.
  virtual std::optional<OperatorSample> operatorSample() = 0;
  /// Parameters in force from this iteration on.
  virtual const ParameterValues& parameters() const = 0;
  /// Called after every Add_Tree (one step): lets time pass, publishes, waits while paused. Returns
  /// false to end the run (stopped, or a limit reached).
  virtual bool afterStep() = 0;
  virtual const StopToken& stopToken() const = 0;
  /// The user's semantic edits in force from this iteration on; null: the problem's edits.
  virtual SemanticEditsPtr semanticEdits() const { return nullptr; }
};

/// A growing, single-threaded planner. Created for one problem and seed; `solve` runs until solved or until the host
/// ends it, and may be called again to go on. Reports of single algorithms (operator, coarse plan, stages, members) are
/// further interfaces that a planner may implement; reportOf() returns them.
class Planner {
 public:
  virtual ~Planner() = default;

  /// True when a certified path was found. Precondition: start and a given goal are collision-free.
  virtual bool solve(PlannerHost& host) = 0;

  virtual const std::vector<RoadmapNode>& nodes() const = 0;
  /// The edges, appended while growing. An edge that failed its certificate is removed from the search but stays listed
  /// here, and its index is in droppedEdges().
  virtual const std::vector<RoadmapEdge>& edges() const = 0;
  virtual const std::vector<std::uint32_t>& droppedEdges() const = 0;
  virtual const PlannerCounts& counts() const = 0;
  /// The certified solution, once solved.
  virtual const Path* path() const = 0;
  /// Brings nodes() and edges() up to date, for planners that update them only at intervals. Called when the run ends,
  /// so that the result does not depend on when a caller reads the roadmap.
  virtual void completeRoadmap() {}
  /// The reason why planning cannot go on; nothing while it can. No path can come after it.
  virtual std::optional<Diagnostic> failure() const { return std::nullopt; }
  /// The planner that does a part of this one's work, and reports instead of it; null: there is none.
  virtual const Planner* inner() const { return nullptr; }
};

/// Another interface of the planner or of its inner planner; null where neither implements it.
template <class Report>
const Report* reportOf(const Planner& planner) {
  const auto* report = dynamic_cast<const Report*>(&planner);
  return report == nullptr && planner.inner() != nullptr ? reportOf<Report>(*planner.inner()) : report;
}

/// Name and factory of a planner. Registered by explicit calls (no static initialisers).
struct PlannerEntry {
  std::string id;       ///< id on the command line and in files, for example "birrt"
  Message label;        ///< name in the window
  Message description;  ///< one sentence with the source
  bool usesOperator = false;
  bool complete = true;  ///< goes on until it finds a path or is stopped; false: it may give up
  std::function<std::unique_ptr<Planner>(const Problem&, std::uint64_t seed)> make;
  bool multiLayer = false;  ///< plans coarsely first: needs the environment model
  bool handLeads = false;   ///< the session shortens what the computer adds to the way of the hand
};

class PlannerRegistry {
 public:
  void add(PlannerEntry entry);
  /// The entry of an id; null where it is unknown.
  const PlannerEntry* find(std::string_view id) const;
  const std::vector<PlannerEntry>& entries() const { return entries_; }

 private:
  std::vector<PlannerEntry> entries_;
};

std::vector<std::string> idsOf(const PlannerRegistry& registry);

/// The entry of a planner that turns the object out of its threads by screw motions first and uses the given planner
/// for the rest (threaded_planner.h). For problems without threads it makes the given planner.
PlannerEntry withScrewMotions(PlannerEntry entry);

/// Prefix of the ids of planners for comparison, which only studies and glissade-cli have
/// (engine/study/benchmarks/peer_planners.h).
inline constexpr std::string_view kPeerPrefix = "peer-";

/// The error where a registry without planners for comparison has no planner of the id. The advice is for ids that no
/// registry has.
Diagnostic unknownPlanner(const std::string& id, const Message& advice);

/// All planners for a whole problem: the strategies of both papers.
PlannerRegistry makePlannerRegistry();

/// All planners that can cross one place for the fine planning (paper 2, section 4.2). The planners of paper 1 and of
/// OMPL are in both registries.
PlannerRegistry makeLocalPlannerRegistry();

}  // namespace glissade
