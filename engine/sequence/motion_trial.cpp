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
      turned_(product, fits, prepared_),
      searched_(product, fits, prepared_, seed) {}

/// A search is refused by those that block the straight lines and those that the body fits.
RemovalAnswer MotionTrial::tryRemoval(std::size_t body, const BodySet& present, int effort, const StopToken& stop) {
  if (effort == 0) return tryDirectly(body, present, stop);
  RemovalAnswer answer = searched_.tryRemoval(body, present, kSearchSteps[static_cast<std::size_t>(effort - 1)], stop);
  auto* refused = std::get_if<Refused>(&answer);
  if (refused == nullptr || refused->stopped) return answer;
  const RemovalAnswer direct = tryDirectly(body, present, stop);
  const auto* lines = std::get_if<Refused>(&direct);
  if (lines == nullptr || lines->stopped) return direct;
  std::set<std::size_t> blocking(lines->blockedBy.begin(), lines->blockedBy.end());
  for (const Fit& fit : fits_.fitsOf(body, present)) blocking.insert(fit.obstacle);
  refused->blockedBy.assign(blocking.begin(), blocking.end());
  return answer;
}

/// Both are refused by those that block either.
RemovalAnswer MotionTrial::tryDirectly(std::size_t body, const BodySet& present, const StopToken& stop) {
  RemovalAnswer straight = straight_.tryRemoval(body, present, stop);
  auto* lines = std::get_if<Refused>(&straight);
  if (lines == nullptr || lines->stopped) return straight;
  RemovalAnswer turned = turned_.tryRemoval(body, present, stop);
  const auto* turns = std::get_if<Refused>(&turned);
  if (turns == nullptr || turns->stopped) return turned;
  std::set<std::size_t> blocking(lines->blockedBy.begin(), lines->blockedBy.end());
  blocking.insert(turns->blockedBy.begin(), turns->blockedBy.end());
  lines->blockedBy.assign(blocking.begin(), blocking.end());
  return straight;
}

void MotionTrial::learn(std::size_t body, const std::vector<PathPoint>& path) { straight_.learn(body, path); }

}  // namespace glissade
