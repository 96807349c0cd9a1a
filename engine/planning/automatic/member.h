#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/planning/automatic/portfolio.h"
#include "engine/planning/planner.h"

namespace glissade {

/// A planner in the automatic one: how it is made for each of its lives, and how it is dealt work.
struct Member {
  std::string name;  ///< in reports
  Contender contender;
  /// For a life with this number, from 1; called for several lives at once.
  std::function<std::unique_ptr<Planner>(std::uint64_t seed, std::uint64_t life)> make;
};

/// The members that may solve this problem. Explicit, no static initialisers.
std::vector<Member> makeMembers(const Problem& problem);

}  // namespace glissade
