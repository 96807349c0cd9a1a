#pragma once

#include <memory>
#include <optional>

#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/contact/interaction_tuner.h"
#include "engine/planning/planner.h"
#include "engine/planning/random_shooter.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// What the operator's authority is used for.
enum class OperatorUse {
  None,             ///< plain BiRRT: alpha is 1 whatever the parameter says
  Guide,            ///< q_device only (paper 1, table I: interactive, no contact)
  GuideAndContact,  ///< Algorithm 1 as printed
  ContactFirst      ///< as the software of 2016: near an obstacle contact sampling pre-empts the draw
};

/// Interactive BiRRT with contact.
///
/// N. Blin, M. Taix, P. Fillatreau, J.-Y. Fourquet, "Tuning Interaction in Motion Planning with
/// Contact", IEEE RO-MAN 2016, Algorithm 1. Deviations: N contact samples take N steps of the loop
/// here, so that a stop, a pause or a changed parameter is seen between any two; near-duplicates of
/// the operator's samples are not kept, and an operator at rest cedes his authority once he has had
/// kRestBudget configurations from one place; every delivered path is certified.
class InteractiveContactBirrt final : public Planner {
 public:
  InteractiveContactBirrt(const Problem& problem, std::uint64_t seed, OperatorUse operatorUse);

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return roadmap_.nodes(); }
  const std::vector<RoadmapEdge>& edges() const override { return roadmap_.edges(); }
  const std::vector<std::uint32_t>& droppedEdges() const override { return roadmap_.droppedEdges(); }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return path_ ? &*path_ : nullptr; }
  Author authority() const override { return authority_; }
  bool inContactMode() const override { return contactSamplesLeft_ > 0; }
  std::optional<TuningReport> tuning() const override;

 private:
  void iterate(PlannerHost& host);
  bool operatorHasAuthority(double a, double alpha, const std::optional<OperatorSample>& device);
  bool nearContact(const OperatorSample& device, double contactDistance) const;
  void enterContactSampling(const OperatorSample& device, PlannerHost& host);
  void contactSampling(PlannerHost& host);
  void operatorShooter(const OperatorSample& device, PlannerHost& host);
  void randomShooter(PlannerHost& host);

  void addTree(const Pose& q, Author author, PlannerHost& host);
  std::optional<RoadmapGraph::Node> extend(RoadmapGraph::ComponentId component, const Pose& q, Author author,
                                           std::optional<RoadmapGraph::Node>& reached, PlannerHost& host);
  void connect(const std::vector<RoadmapGraph::Node>& added, PlannerHost& host);
  bool isDuplicate(RoadmapGraph::ComponentId component, const Pose& q, Author author) const;
  void deliverPath(PlannerHost& host);
  void updateCounts();
  InteractionSettings settings(const ParameterValues& parameters) const;
  void observeStep(std::size_t edgesBefore, PlannerHost& host);
  double longestEdge(std::size_t first) const;

  Problem problem_;
  OperatorUse operatorUse_;
  std::unique_ptr<CollisionQuery> query_;
  RandomStream authorityStream_;
  RandomShooter randomShooter_;
  ContactSampler contactSampler_;
  RoadmapGraph roadmap_;
  RoadmapGraph::Node startRoot_ = 0;
  std::vector<RoadmapGraph::Node> goalRoots_;

  Author authority_ = Author::Computer;
  int contactSamplesLeft_ = 0;
  std::uint64_t restingAt_ = 0;   ///< OperatorSample::moves of the place the operator was last used at
  std::uint64_t usedAtRest_ = 0;  ///< configurations shot from that place

  InteractionTuner tuner_;
  bool held_ = false;              ///< somebody held the object at the last iteration
  int tuned_ = 0;                  ///< bits of TunedSetting at the last step
  double contactClearance_ = 0.0;  ///< of the hand when contact mode was entered last

  PlannerCounts counts_;
  std::optional<Path> path_;
};

}  // namespace glissade
