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

/// A planner of the portfolio: how it is made for each of its lives, and how it is dealt work.
struct Member {
  std::string name;  ///< name in reports
  Contender contender;
  /// Makes the planner for a life with this number, from 1. Called for several lives at once.
  std::function<std::unique_ptr<Planner>(std::uint64_t seed, std::uint64_t life)> make;
  bool shares = false;  ///< a SamplerMaker, where there is one, makes its sampler
};

/// Makes the sampler of a member's life from the member's own sampler. `slides`: the member's trees go on in contact.
/// Called on any thread.
using SamplerMaker = std::function<std::unique_ptr<ConfigurationSampler>(std::unique_ptr<ConfigurationSampler> own,
                                                                         std::uint64_t seed, bool slides)>;

/// The members that may solve this problem. `sampler` makes the samplers of the members with RrtConnect trees; null:
/// they keep their own.
std::vector<Member> makeMembers(const Problem& problem, const std::shared_ptr<ErodedWorlds>& worlds,
                                const SamplerMaker& sampler);
std::vector<Member> makeMembers(const Problem& problem);

/// Options for trees whose metric gives rotations a small weight: an extension turns far while it moves little. `range`
/// is a share of the largest distance between two configurations.
RrtConnect::Options turning(const Problem& problem, double range, double turnWeight);

}  // namespace glissade
