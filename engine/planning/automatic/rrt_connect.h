#pragma once

#include <memory>
#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/planner.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// A share of the largest distance between two configurations of the problem, in a metric in which
/// rotations weigh `turnWeight` of what they do in the object's.
double searchRange(const Problem& problem, double share, double turnWeight = 1.0);

/// RRT-Connect (J. J. Kuffner, S. M. LaValle, "RRT-Connect: An efficient approach to single-query path
/// planning", 2000) with short extensions, which is what matters most in tight places. Optionally the
/// dynamic domain (L. Jaillet, A. Yershova, S. M. LaValle, T. Simeon, "Adaptive tuning of the sampling
/// domain for dynamic-domain RRTs", 2005): a node that failed to grow draws from near it only, so that
/// trapped trees do not push against their walls for ever.
/// Deviation: the delivered path is certified; an edge that is not is dropped, and from then on edges
/// are sampled more finely.
class RrtConnect final : public Planner {
 public:
  enum class Growth {
    Both,       ///< by turns, each connecting to what the other grew by
    FromStart,  ///< one tree, one draw in twenty is the goal (S. M. LaValle, J. J. Kuffner 2001)
    FromGoal
  };
  struct Options {
    double range = 0.0;       ///< longest extension, metres in the search's metric; > 0
    double domain = 0.0;      ///< first radius of the dynamic domain, in ranges; 0: none
    double turnWeight = 1.0;  ///< of rotations, relative to the metric of the object's radius: with a
                              ///< small one an extension turns far while it moves little
    Growth growth = Growth::Both;
  };

  RrtConnect(const Problem& problem, std::uint64_t seed, const Options& options,
             std::unique_ptr<ConfigurationSampler> sampler);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes(); }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges(); }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges(); }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }

 private:
  using Node = RoadmapGraph::Node;
  using ComponentId = RoadmapGraph::ComponentId;
  enum class Outcome { Trapped, Advanced, Reached };
  struct Extension {
    Outcome outcome;
    Node node;
  };

  void iterate(PlannerHost& host);
  void growBoth(PlannerHost& host);
  void growOne(PlannerHost& host);
  /// The node that the component grew by towards q.
  std::optional<Node> grow(ComponentId component, const Pose& q, PlannerHost& host);
  Node addChild(Node parent, const Pose& q);
  Extension extend(Node from, const Pose& q, PlannerHost& host);
  void connect(ComponentId component, Node target, PlannerHost& host);
  ComponentId nearestOther(ComponentId grown, const Pose& q) const;
  void adapt(Node node, bool grew);
  void deliverPath(PlannerHost& host);
  void updateCounts();

  Problem problem_;
  Options options_;
  std::unique_ptr<ConfigurationSampler> sampler_;
  std::unique_ptr<CollisionQuery> query_;
  RandomStream goalStream_;
  Se3Metric metric_;
  RoadmapGraph roadmap_;
  Node startRoot_ = 0;
  std::vector<Node> goalRoots_;
  std::vector<double> domains_;  ///< per node: farther samples are refused
  std::uint64_t turn_ = 0;
  bool joined_ = false;      ///< components were joined: there may be a path
  double refinement_ = 1.0;  ///< of the growth step
  PlannerCounts counts_;
  std::optional<Path> path_;
};

}  // namespace glissade
