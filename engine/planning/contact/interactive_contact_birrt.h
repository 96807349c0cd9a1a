#pragma once

#include <optional>

#include "engine/planning/contact/add_tree_planner.h"
#include "engine/planning/contact/contact_follower.h"
#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/contact/hand_trail.h"
#include "engine/planning/contact/interaction_report.h"
#include "engine/planning/contact/interaction_tuner.h"
#include "engine/planning/random_shooter.h"

namespace glissade {

/// Use of the operator's configurations.
enum class OperatorUse {
  None,                 ///< plain BiRRT: alpha is 1 whatever the parameter says
  Guide,                ///< q_device only (paper 1, table I: interactive, no contact)
  GuideAndContact,      ///< Algorithm 1 as printed
  GuideAndFollow,       ///< Algorithm 1, with contact samples that follow the surfaces
  ContactFirst,         ///< as in the software of 2016: near an obstacle contact sampling comes before the draw
  GuideContactAndTrail  ///< Algorithm 1, and the way of the hand is a third tree
};

/// Interactive BiRRT with contact.
///
/// N. Blin, M. Taix, P. Fillatreau, J.-Y. Fourquet, "Tuning Interaction in Motion Planning with Contact", IEEE RO-MAN
/// 2016, Algorithm 1. Deviations: N contact samples take N steps of the loop here, so that a stop, a pause or a changed
/// parameter is seen between any two; near-duplicates of the operator's samples are not kept, and an operator at rest
/// loses authority after kRestBudget configurations from one pose; every delivered path is certified.
/// GuideContactAndTrail deviates further: the way of the hand is a third tree (HandTrail), a hand that has not moved
/// has no authority, and at alpha = 0 the computer draws nothing while the hand rests.
class InteractiveContactBirrt final : public AddTreePlanner, public ReportsInteraction {
 public:
  InteractiveContactBirrt(const Problem& problem, std::uint64_t seed, OperatorUse operatorUse);

  bool solve(PlannerHost& host) override;

  Author authority() const override { return lastAuthor(); }
  bool inContactMode() const override { return contactSamplesLeft_ > 0; }
  std::optional<TuningReport> tuning() const override;

  /// The longest way that the hand has shown, every edge certified: from the start, where it is joined to the start's
  /// tree, else to the goal, where it is joined to that, else on its own.
  struct HandWay {
    std::vector<PathPoint> points;  ///< empty: the hand has shown nothing
    bool fromStart = false;
    bool toGoal = false;
  };
  HandWay handWay(PlannerHost& host);

 private:
  void followHand(PlannerHost& host);
  void iterate(PlannerHost& host);
  bool operatorHasAuthority(double a, double alpha, const std::optional<OperatorSample>& device);
  bool nearContact(const OperatorSample& device, double contactDistance) const;
  void enterContactSampling(const OperatorSample& device, PlannerHost& host);
  void contactSampling(PlannerHost& host);
  void operatorShooter(const OperatorSample& device, PlannerHost& host);
  void randomShooter(PlannerHost& host);

  void observeStep(std::size_t edgesBefore, PlannerHost& host);

  OperatorUse operatorUse_;
  RandomStream authorityStream_;
  RandomShooter randomShooter_;
  ContactSampler contactSampler_;
  ContactFollower contactFollower_;
  HandTrail trail_;

  int contactSamplesLeft_ = 0;
  std::uint64_t restingAt_ = 0;   ///< OperatorSample::moves of the operator's pose that was used last
  std::uint64_t usedAtRest_ = 0;  ///< configurations shot from that pose

  InteractionTuner tuner_;
  bool held_ = false;              ///< a person held the object at the last iteration
  int tuned_ = 0;                  ///< bits of TunedSetting at the last step
  double contactClearance_ = 0.0;  ///< clearance of the hand when contact mode was entered last
};

}  // namespace glissade
