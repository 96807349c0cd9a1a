#pragma once

#include "engine/planning/contact/add_tree_planner.h"
#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/contact/interaction_report.h"
#include "engine/planning/contact/interaction_tuner.h"
#include "engine/planning/interactive/gap_bridges.h"
#include "engine/planning/interactive/hand_report.h"
#include "engine/planning/interactive/shown_configuration.h"
#include "engine/planning/random_shooter.h"

namespace glissade {

/// The trees that a hand draws: each configuration that it shows is made free and handed to Add_Tree (paper 1,
/// Algorithm 1, lines 5 to 9). Where the start's tree does not get along the hand's way, configurations about the first
/// stretch that is missing are tried, and near an obstacle N contact samples. On the computer's steps it draws
/// configurations, too: everywhere, and between the hand and the goal.
class HandFollower final : public AddTreePlanner, public ReportsInteraction, public ReportsHand {
 public:
  HandFollower(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds);

  bool solve(PlannerHost& host) override;

  Author authority() const override { return computersTurn_ ? Author::Computer : lastAuthor(); }
  bool inContactMode() const override { return contactSamplesLeft_ > 0; }
  std::optional<TuningReport> tuning() const override;
  const HandReport& handReport() const override { return report_; }

  /// Whose the next step is.
  enum class Turn { Hand, Computer };
  void setTurn(Turn turn) { turn_ = turn; }
  /// A step of the hand has something to do: it has moved, or, with `extras`, the trees lag behind its way.
  bool hasWork(const OperatorSample& sample, bool extras) const;
  InteractionSettings settings(const ParameterValues& parameters) const;
  /// The portfolio had a turn with the hand held: the tuner learns from it.
  void noteComputerTurn(double reach);
  void pathFound(bool joined, double followed);

  const WayRecorder& way() const { return way_.recorder(); }
  /// Steps since the trees last grew.
  std::uint64_t stepsWithoutGrowth() const { return stepsWithoutGrowth_; }

 private:
  void step(PlannerHost& host);
  void follow(const Pose& q, PlannerHost& host);
  void sampleContact(PlannerHost& host);
  void searchGap(PlannerHost& host);
  void sampleGap(PlannerHost& host);
  void sampleForComputer(PlannerHost& host);
  void slide(const Pose& q, PlannerHost& host);
  bool movedFar(const Pose& q) const;
  bool startTreeIsAt(const Pose& q) const;
  void followWay();
  void observe(std::size_t edgesBefore, PlannerHost& host);

  RandomStream stream_;
  RandomShooter shooter_;
  ContactSampler contactSampler_;
  std::shared_ptr<ErodedWorlds> worlds_;
  ShownConfiguration configuration_;
  FollowedWay way_;
  GapBridges gaps_;
  InteractionTuner tuner_;
  HandReport report_;
  Pose shown_;  ///< what the hand showed last, as it did
  Pose free_;   ///< the same, made free
  int contactSamplesLeft_ = 0;
  int gapSamplesLeft_ = 0;
  Turn turn_ = Turn::Hand;
  bool gapNext_ = false;  ///< while the hand moves and the trees lag, its configurations and the gap's take turns
  double contactClearance_ = 0.0;
  std::uint64_t stepsWithoutGrowth_ = 0;
  int tuned_ = 0;  ///< bits of TunedSetting at the last step
  bool computersTurn_ = true;
};

}  // namespace glissade
