#pragma once

#include "engine/planning/automatic/portfolio_partner.h"
#include "engine/planning/interactive/hand_account.h"
#include "engine/planning/interactive/hand_follower.h"
#include "engine/planning/interactive/preferred_places.h"

namespace glissade {

/// A person as the partner of the portfolio.
///
/// Authority is that of Algorithm 1 (paper 1), step by step: a number a is drawn, and for a > alpha the step is the
/// hand's, where it has shown something new. A round does several steps at once; they count as the computer's next
/// steps. Members draw from the tube about the hand's way, as much as HandAccount covers. While the hand works in
/// contact, members whose trees slide on in contact take half of their draws there. The members get no additional work,
/// so that a misleading hand makes these members slower by a factor of two at most, and the others not at all. The hand
/// loses most of its authority while its steps grow nothing. Members draw from the places that a person prefers, too.
/// Without a hand and without a preferred place, no random number is drawn and nothing is shared: the portfolio then
/// gives the same result as without a partner, bit by bit.
class HandPartner final : public PortfolioPartner {
 public:
  HandPartner(const Problem& problem, std::uint64_t seed);

  bool takesTurn(PlannerHost& host) override;
  SubPlanner& planner() override { return planner_; }
  const SubPlanner& planner() const override { return planner_; }
  void turnDone(std::uint64_t work) override;
  void roundDone(const RoundOutcome& outcome) override;
  void solved(const Path& path, bool shared) override;

  std::uint64_t mostWork() const override { return mostWork_; }
  std::unique_ptr<ConfigurationSampler> sampler(std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
                                                bool slides) const override;
  const std::shared_ptr<ErodedWorlds>& worlds() const override { return worlds_; }
  const HandAccount& account() const { return account_; }

 private:
  HandPartner(const Problem& problem, std::uint64_t seed, const std::shared_ptr<ErodedWorlds>& worlds);
  HandPartner(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds,
              std::unique_ptr<HandFollower> follower);
  void noteMovement(const Pose& q);
  void publish(const ParameterValues& parameters, const std::optional<Pose>& hand);
  double share(const ParameterValues& parameters) const;
  double followedShare(const Path& path) const;

  Problem problem_;
  std::shared_ptr<ErodedWorlds> worlds_;
  RandomStream authorityStream_;
  std::shared_ptr<WayBoard> board_ = std::make_shared<WayBoard>();
  std::shared_ptr<PreferredPlaces> preferred_ = std::make_shared<PreferredPlaces>();
  HandFollower* follower_;  ///< owned by planner_
  SubPlanner planner_;
  HandAccount account_;
  std::uint64_t prepaid_ = 0;  ///< steps of the computer that were taken in advance
  Pose beforeRound_;           ///< pose of the hand when the round began
  std::uint64_t mostWork_ = kMostWork;
  std::uint64_t published_ = 0;  ///< version of the published way
  std::optional<Pose> publishedHand_;
  bool held_ = false;              ///< a person held the object when the round began
  std::uint64_t lastQuantum_ = 0;  ///< quantum of the round before; 0: it was evaluated

  static constexpr std::uint64_t kMostWork = 10'000;
};

}  // namespace glissade
