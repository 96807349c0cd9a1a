#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/automatic/sliding_extension.h"
#include "engine/planning/tree_planner.h"

namespace glissade {

/// A share of the largest distance between two configurations of the problem, in a metric in which
/// rotations weigh `turnWeight` of what they do in the object's.
double searchRange(const Problem& problem, double share, double turnWeight = 1.0);

/// RRT-Connect (J. J. Kuffner, S. M. LaValle, "RRT-Connect: An efficient approach to single-query path
/// planning", 2000) with short extensions, which is what matters most in narrow passages. Optionally the
/// dynamic domain (L. Jaillet, A. Yershova, S. M. LaValle, T. Simeon, "Adaptive tuning of the sampling
/// domain for dynamic-domain RRTs", 2005): a node that failed to grow draws from near it only, so that
/// trapped trees do not push against their walls for ever.
/// Optionally extensions that are blocked slide on in contact.
/// Deviation: the delivered path is certified; an edge that is not is dropped, and from then on edges
/// are sampled more finely.
class RrtConnect final : public TreePlanner {
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
    std::uint64_t longDraws = 0;  ///< for so many draws at first extensions are ten times as long: in open space
    bool slides = false;          ///< an extension that is blocked goes on in contact (SlidingExtension)
  };

  RrtConnect(const Problem& problem, std::uint64_t seed, const Options& options,
             std::unique_ptr<ConfigurationSampler> sampler);

  bool solve(PlannerHost& host) override;

 private:
  /// What a tree got by an extension: its end is a node unless it is Reached or Trapped. Blocked: it ends before the
  /// obstacle, or slid along it.
  struct Extended {
    Progress progress;
    Node node;
  };

  void iterate(PlannerHost& host);
  void growBoth(PlannerHost& host);
  void growOne(PlannerHost& host);
  /// The node that the component grew by towards q.
  std::optional<Node> grow(ComponentId component, const Pose& q, PlannerHost& host);
  Node addChild(Node parent, const Pose& q);
  Pose draw(ComponentId tree);
  Extended extend(Node from, const Pose& q, PlannerHost& host);
  Extended slideOn(Node from, const Pose& q, double step, const StopToken& stop);
  void connect(ComponentId component, Node target, PlannerHost& host);
  ComponentId nearestOther(ComponentId grown, const Pose& q) const;
  void adapt(Node node, bool grew);
  void deliverPath(PlannerHost& host);
  Box3& boxOf(TreeSide side) { return boxes_[side == TreeSide::Start ? 0 : 1]; }
  const Box3& boxOf(ComponentId component) {
    return boxOf(component == roadmap_.componentOf(startRoot_) ? TreeSide::Start : TreeSide::Goal);
  }

  Options options_;
  double range_ = 0.0;  ///< of extensions at present
  std::unique_ptr<ConfigurationSampler> sampler_;
  Author author_ = Author::Computer;  ///< of what the trees grow towards
  RandomStream goalStream_;
  std::optional<SlidingExtension> sliding_;
  std::vector<double> domains_;  ///< per node: farther samples are refused
  std::array<Box3, 2> boxes_;    ///< of the nodes' positions, by their side
  std::uint64_t turn_ = 0;
  bool joined_ = false;      ///< components were joined: there may be a path
  double refinement_ = 1.0;  ///< of the growth step
};

}  // namespace glissade
