#pragma once

#include <cstdint>
#include <memory>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/fine/sub_planner.h"

namespace glissade {

/// What a round of a portfolio has brought.
struct RoundOutcome {
  std::uint64_t quantum = 0;  ///< work that each slot was dealt
  std::uint64_t turns = 0;
  std::uint64_t work = 0;  ///< of all members
  double reach = 0.0;      ///< the longest edge that was added, metres in the metric; 0 where nothing was
};

/// Works with a portfolio: it takes turns between the rounds, and draws configurations for the members. Called by the
/// thread that calls solve() of the portfolio, except where stated.
class PortfolioPartner {
 public:
  virtual ~PortfolioPartner() = default;

  /// Asked before each round. True: planner() has one step in its place.
  virtual bool takesTurn(PlannerHost& host) = 0;
  virtual SubPlanner& planner() = 0;
  virtual const SubPlanner& planner() const = 0;
  virtual void turnDone(std::uint64_t work) = 0;
  virtual void roundDone(const RoundOutcome& outcome) = 0;
  /// `shared`: found by the partner's own planner, or by a member that draws from its sampler.
  virtual void solved(const Path& path, bool shared) = 0;

  /// Of the problem; all members share them.
  virtual const std::shared_ptr<ErodedWorlds>& worlds() const = 0;
  /// Most work of a slot in the next round.
  virtual std::uint64_t mostWork() const = 0;
  /// The sampler of a life of a member, given its own. `slides`: the member's trees go on in contact. On any thread.
  virtual std::unique_ptr<ConfigurationSampler> sampler(std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
                                                        bool slides) const = 0;
};

}  // namespace glissade
