#pragma once

#include "engine/planning/interactive/followed_way.h"
#include "engine/planning/interactive/gap_search.h"

namespace glissade {

/// Local planning from the start's tree to points of the hand's way that it has not reached: one search after the
/// other, each to another point. The first has a hundred steps, the next ones follow Luby's sequence.
class GapBridges {
 public:
  using Node = RoadmapGraph::Node;

  GapBridges(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds);

  struct Bridge {
    Node from;                ///< of the tree
    std::vector<Pose> poses;  ///< from there
  };
  enum class State { NothingToSearch, Searching, Found };
  /// One step. NothingToSearch: no point that the tree has not reached is free; nothing was done.
  State step(const RoadmapGraph& roadmap, RoadmapGraph::ComponentId tree, const FollowedWay& way, PlannerHost& host);
  /// The bridge that was found last.
  const Bridge& bridge() const { return bridge_; }
  /// The queries of all searches.
  QueryCounts queries() const;

 private:
  void begin(const RoadmapGraph& roadmap, RoadmapGraph::ComponentId tree, const FollowedWay& way);
  void end();

  Problem problem_;
  Se3Metric metric_;
  RandomStream stream_;
  std::shared_ptr<ErodedWorlds> worlds_;
  std::optional<GapSearch> search_;
  Bridge bridge_;             ///< of the present search; without poses until one is found
  std::uint64_t inVain_ = 0;  ///< searches since one found a way, the present one with them
  QueryCounts past_;          ///< of searches that are over
};

}  // namespace glissade
