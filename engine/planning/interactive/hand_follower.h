#pragma once

#include "engine/planning/contact/add_tree_planner.h"
#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/contact/interaction_report.h"
#include "engine/planning/contact/interaction_tuner.h"
#include "engine/planning/interactive/hand_report.h"
#include "engine/planning/interactive/shown_configuration.h"
#include "engine/planning/interactive/shown_way.h"

namespace glissade {

/// The trees that a hand draws: each configuration that it shows is made free and handed to Add_Tree (paper 1,
/// Algorithm 1, lines 5 to 9); near an obstacle N contact samples follow it. Where the start's tree does not get there,
/// some configurations between the tree and the hand are tried, too. It has work only after the hand has moved: what
/// searches elsewhere is the portfolio.
class HandFollower final : public AddTreePlanner, public ReportsInteraction, public ReportsHand {
 public:
  HandFollower(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds);

  bool solve(PlannerHost& host) override;

  Author authority() const override { return computersTurn_ ? Author::Computer : lastAuthor(); }
  bool inContactMode() const override { return contactSamplesLeft_ > 0; }
  std::optional<TuningReport> tuning() const override;
  const HandReport& handReport() const override { return report_; }

  /// The next step has something to do. `extras`: contact samples and what is between the tree and the hand count.
  bool hasWork(const OperatorSample& sample, bool extras) const;
  InteractionSettings settings(const ParameterValues& parameters) const;
  /// The portfolio had a turn with the hand held: the tuner learns from it.
  void computerHadTurn(double reach);
  void pathFound(bool joined, double followed);

  const WayRecorder& way() const { return way_; }
  /// Steps since the trees last grew.
  std::uint64_t stepsInVain() const { return stepsInVain_; }

 private:
  void step(PlannerHost& host);
  void follow(const Pose& q, PlannerHost& host);
  void sampleContact(PlannerHost& host);
  void sampleBetween(PlannerHost& host);
  bool startTreeIsAt(const Pose& q) const;
  void observe(std::size_t edgesBefore, PlannerHost& host);

  RandomStream stream_;
  ContactSampler contactSampler_;
  ShownConfiguration configuration_;
  WayRecorder way_;
  InteractionTuner tuner_;
  HandReport report_;
  Pose shown_;  ///< what the hand showed last, as it did
  Pose free_;   ///< the same, made free
  int contactSamplesLeft_ = 0;
  int betweenLeft_ = 0;
  double contactClearance_ = 0.0;
  std::uint64_t stepsInVain_ = 0;
  int tuned_ = 0;  ///< bits of TunedSetting at the last step
  bool computersTurn_ = true;
};

}  // namespace glissade
