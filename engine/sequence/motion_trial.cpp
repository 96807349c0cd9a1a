#include "engine/sequence/motion_trial.h"

#include <algorithm>
#include <array>
#include <set>

namespace glissade {
namespace {

/// Steps of the automatic planner: about a quarter of a second, one, four and sixteen.
constexpr std::array<std::uint64_t, MotionTrial::kMostSearches> kSearchSteps{150, 600, 2400, 9600};

}  // namespace

MotionTrial::MotionTrial(const AssembledProduct& product, const ProductFits& fits, std::uint64_t seed, int searches)
    : fits_(fits),
      searches_(searches),
      prepared_(product.bodies),
      straight_(product, fits, prepared_),
      searched_(product, fits, prepared_, seed) {}

/// A search is refused by those that block the straight lines and those that the body fits.
RemovalAnswer MotionTrial::tryRemoval(std::size_t body, const BodySet& present, int effort, const StopToken& stop) {
  if (effort == 0) return straight_.tryRemoval(body, present, stop);
  RemovalAnswer answer = searched_.tryRemoval(body, present, kSearchSteps[static_cast<std::size_t>(effort - 1)], stop);
  auto* refused = std::get_if<Refused>(&answer);
  if (refused == nullptr || refused->stopped) return answer;
  const RemovalAnswer straight = straight_.tryRemoval(body, present, stop);
  const auto* lines = std::get_if<Refused>(&straight);
  if (lines == nullptr) return straight;
  if (lines->stopped) return straight;
  std::set<std::size_t> blocking(lines->blockedBy.begin(), lines->blockedBy.end());
  for (const Fit& fit : fits_.fitsOf(body, present)) blocking.insert(fit.obstacle);
  refused->blockedBy.assign(blocking.begin(), blocking.end());
  return answer;
}

void MotionTrial::learn(std::size_t body, const std::vector<PathPoint>& path) { straight_.learn(body, path); }

}  // namespace glissade
