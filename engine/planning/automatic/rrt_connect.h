#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/automatic/sliding_extension.h"
#include "engine/planning/tree_planner.h"

namespace glissade {

/// A share of the largest distance between two configurations of the problem. The metric weighs rotations by
/// `turnWeight` relative to the object's metric.
double searchRange(const Problem& problem, double share, double turnWeight = 1.0);

/// RRT-Connect (J. J. Kuffner, S. M. LaValle, "RRT-Connect: An efficient approach to single-query path planning", 2000)
/// with short extensions, which matter most in narrow passages. The dynamic domain is optional (L. Jaillet, A.
/// Yershova, S. M. LaValle, T. Simeon, "Adaptive tuning of the sampling domain for dynamic-domain RRTs", 2005): a node
/// that failed to grow draws only from its neighbourhood, so that trapped trees do not extend into walls for ever.
/// Sliding is optional, too: a blocked extension goes on in contact. Deviation: the delivered path is certified. An
/// edge that fails its certificate is dropped, and from then on edges are sampled more finely.
class RrtConnect final : public TreePlanner {
 public:
  enum class Growth {
    Both,       ///< two trees in turn, each connecting to the new node of the other
    FromStart,  ///< one tree, one draw in twenty is the goal (S. M. LaValle, J. J. Kuffner 2001)
    FromGoal
  };
  struct Options {
    double range = 0.0;   ///< longest extension, metres in the search's metric; > 0
    double domain = 0.0;  ///< first radius of the dynamic domain, in multiples of the range; 0: none
    /// Weight of rotations, relative to the metric of the object's radius: with a small weight an extension turns far
    /// while it moves little.
    double turnWeight = 1.0;
    Growth growth = Growth::Both;
    /// Number of first draws with extensions ten times as long, for open space. They end early where few extensions of
    /// that length are free.
    std::uint64_t longDraws = 0;
    bool slides = false;  ///< an extension that is blocked goes on in contact (SlidingExtension)
  };

  RrtConnect(const Problem& problem, std::uint64_t seed, const Options& options,
             std::unique_ptr<ConfigurationSampler> sampler);

  bool solve(PlannerHost& host) override;

 private:
  /// Result of an extension. Its end is a node unless the progress is Reached or Trapped. Blocked: the end lies before
  /// the obstacle, or the extension slid along it.
  struct Extended {
    Progress progress;
    Node node;
  };

  void iterate(PlannerHost& host);
  void growBoth(PlannerHost& host);
  void growOne(PlannerHost& host);
  /// The last node that the component added towards q.
  std::optional<Node> grow(ComponentId component, const Pose& q, PlannerHost& host);
  Node addChild(Node parent, const Pose& q);
  Pose draw(ComponentId tree);
  Extended extend(Node from, const Pose& q, PlannerHost& host);
  Extended slideOn(Node from, const Pose& q, double step, const StopToken& stop);
  void connect(ComponentId component, Node target, PlannerHost& host);
  ComponentId nearestOther(ComponentId grown, const Pose& q) const;
  bool drawsLong() const;
  void adapt(Node node, bool grew);
  void deliverPath(PlannerHost& host);
  Box3& boxOf(TreeSide side) { return boxes_[side == TreeSide::Start ? 0 : 1]; }
  const Box3& boxOf(ComponentId component) {
    return boxOf(component == roadmap_.componentOf(startRoot_) ? TreeSide::Start : TreeSide::Goal);
  }

  Options options_;
  double range_ = 0.0;           ///< present range of extensions
  std::uint64_t longTried_ = 0;  ///< extensions of long draws
  std::uint64_t longFree_ = 0;   ///< those of them that no obstacle blocked
  std::unique_ptr<ConfigurationSampler> sampler_;
  Author author_ = Author::Computer;  ///< author of the configuration that the trees grow towards
  RandomStream goalStream_;
  std::optional<SlidingExtension> sliding_;
  std::vector<double> domains_;  ///< one entry per node: the node refuses farther samples
  std::array<Box3, 2> boxes_;    ///< bounding boxes of the nodes' positions, by tree side
  std::uint64_t turn_ = 0;
  bool joined_ = false;      ///< components were joined, so that there may be a path
  double refinement_ = 1.0;  ///< factor of the growth step
};

}  // namespace glissade
