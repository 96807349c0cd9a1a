#pragma once

#include <memory>
#include <string_view>

#include "engine/base/message.h"
#include "engine/planning/planner.h"

namespace glissade {

/// The planners of the Open Motion Planning Library (I. A. Sucan, M. Moll, L. E. Kavraki, "The Open Motion Planning
/// Library", 2012) that users can choose.
enum class OmplAlgorithm {
  RrtConnect,  ///< Kuffner and LaValle 2000
  Bkpiece,     ///< Sucan and Kavraki 2009, two trees
  Prm,         ///< Kavraki et al. 1996
  Est,         ///< Hsu et al. 1999
  Rrt,         ///< LaValle 1998
  Trrt,        ///< Jaillet, Cortés and Siméon 2010
  BiTrrt       ///< Devaurs, Siméon and Cortés 2013, two trees
};

/// Interface between OMPL's planners and the engine.
enum class OmplManner {
  /// Like the engine's own planners: with its metric, extensions, collision checks and certified paths.
  Adapted,
  /// The use by OMPL's own users, for comparison: OMPL's SE(3), its defaults (except for the parameters ompl_range and
  /// ompl_resolution), edges checked at intervals, and collisions of the surfaces by FCL. The first path is the result,
  /// and our certificate judges it. A path that fails ends the run and is counted (PlannerCounts::rejectedPaths).
  AsItIs
};

/// One of OMPL's planners behind our interface, with our metric, random configurations, collision checks along the
/// edges and certificate (OmplManner::Adapted). OMPL's planner is called in pieces of one or two draws (AsItIs: of
/// many). A path that fails its certificate restarts it, with random numbers that go on and with edges that are
/// certified while they grow, so that a path fails once at most. The nodes grown so far stay listed. Deviations: a step
/// of the lockstep clock is a draw, not a configuration kept; new nodes are published after a number of draws, in the
/// order in which they grew.
class OmplPlanner final : public Planner {
 public:
  OmplPlanner(const Problem& problem, std::uint64_t seed, OmplAlgorithm algorithm,
              OmplManner manner = OmplManner::Adapted);
  ~OmplPlanner() override;

  bool solve(PlannerHost& host) override;
  void completeRoadmap() override;

  const std::vector<RoadmapNode>& nodes() const override { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }

 private:
  struct Engine;

  void grow(PlannerHost& host);
  void deliverPath(PlannerHost& host);
  /// Appends the nodes and edges that OMPL's planner has grown since the last call.
  void collect();
  template <class Work>
  void guard(CatalogueText doing, const Work& work);
  void fail(ErrorKind kind, const Message& reason, const Message& advice);

  std::unique_ptr<Engine> engine_;  ///< null where OMPL could not be set up
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  PlannerCounts counts_;
  std::uint64_t owedSteps_ = 0;       ///< draws of the last piece that are not yet counted as steps
  std::uint64_t nextCollection_ = 1;  ///< draws at the next collection
  std::uint64_t collectedAt_ = 0;     ///< pieces at the last collection
  std::optional<Path> path_;
  std::optional<Diagnostic> failure_;
};

}  // namespace glissade
