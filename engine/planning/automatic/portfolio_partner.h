#pragma once

#include <cstdint>
#include <memory>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// Outcome of a round of a portfolio.
struct RoundOutcome {
  std::uint64_t quantum = 0;  ///< limit of work of each slot
  std::uint64_t turns = 0;
  std::uint64_t work = 0;  ///< work of all members
  double reach = 0.0;      ///< length of the longest added edge, metres in the metric; 0 if none was added
};

/// Works with a portfolio: it takes turns between the rounds, and draws configurations for the members. The thread that
/// calls solve() of the portfolio calls these functions, except where stated.
class PortfolioPartner {
 public:
  virtual ~PortfolioPartner() = default;

  /// Asked before each round. True: planner() does one step instead of the round.
  virtual bool takesTurn(PlannerHost& host) = 0;
  virtual SubPlanner& planner() = 0;
  virtual const SubPlanner& planner() const = 0;
  virtual void turnDone(std::uint64_t work) = 0;
  virtual void roundDone(const RoundOutcome& outcome) = 0;
  /// `shared`: the partner's own planner found the path, or a member that draws from the partner's sampler.
  virtual void solved(const Path& path, bool shared) = 0;

  /// Eroded worlds of the problem; all members share them.
  virtual const std::shared_ptr<ErodedWorlds>& worlds() const = 0;
  /// Largest work of a slot in the next round.
  virtual std::uint64_t mostWork() const = 0;
  /// The sampler of a member's life, given the member's own sampler. `slides`: the member's trees go on in contact.
  /// Called on any thread.
  virtual std::unique_ptr<ConfigurationSampler> sampler(std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
                                                        bool slides) const = 0;
};

}  // namespace glissade
