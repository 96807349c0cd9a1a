#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/portfolio.h"
#include "engine/planning/automatic/rrt_connect.h"
#include "engine/planning/planner.h"

namespace glissade {

/// A planner in the automatic one: how it is made for each of its lives, and how it is dealt work.
struct Member {
  std::string name;  ///< in reports
  Contender contender;
  /// For a life with this number, from 1; called for several lives at once.
  std::function<std::unique_ptr<Planner>(std::uint64_t seed, std::uint64_t life)> make;
  bool shares = false;  ///< its sampler is made by a SamplerMaker, where there is one
};

/// Makes the sampler of a life of a member from its own one. `slides`: the member's trees go on in contact. Called on
/// any thread.
using SamplerMaker = std::function<std::unique_ptr<ConfigurationSampler>(std::unique_ptr<ConfigurationSampler> own,
                                                                         std::uint64_t seed, bool slides)>;

/// The members that may solve this problem. Explicit, no static initialisers. `sampler` makes the samplers of the
/// members that grow trees of our own; null: they keep their own.
std::vector<Member> makeMembers(const Problem& problem, const std::shared_ptr<ErodedWorlds>& worlds,
                                const SamplerMaker& sampler);
std::vector<Member> makeMembers(const Problem& problem);

/// Trees of which rotations weigh little: an extension turns far while it moves little. `range` is a share of the
/// largest distance between two configurations.
RrtConnect::Options turning(const Problem& problem, double range, double turnWeight);

}  // namespace glissade
