#include "engine/planning/automatic/slot.h"

#include "engine/planning/automatic/portfolio_report.h"

namespace glissade {
namespace {

/// What the members do, in quarters of a yes/no query. An iteration looks for neighbours; a draw that
/// is discarded at once costs next to nothing, so that steps do not count but for one a turn.
constexpr std::uint64_t kCollisionWork = 4;
constexpr std::uint64_t kDistanceWork = 16;
constexpr std::uint64_t kMotionWork = 80;
constexpr std::uint64_t kIterationWork = 8;
constexpr std::uint64_t kTurnWork = 1;

std::uint64_t workOf(const PlannerCounts& counts) {
  return kCollisionWork * counts.queries.collision + kDistanceWork * counts.queries.distance +
         kMotionWork * counts.queries.motion + kIterationWork * counts.iterations;
}

}  // namespace

SlotResult runSlot(SubPlanner& life, PlannerHost& host, std::uint64_t quantum) {
  SlotResult result;
  const std::uint64_t before = workOf(life.collected());  // a new life pays for its making, too
  const std::size_t stagesBefore = stagesDoneOf(life.planner());
  do {
    result.state = life.advance(host);
    ++result.turns;
    result.work = workOf(life.planner().counts()) - before + kTurnWork * result.turns;
  } while (result.state == SubPlanner::State::Running && result.work < quantum && !host.stopToken().stopRequested());
  result.gotOn = stagesDoneOf(life.planner()) > stagesBefore;
  return result;
}

}  // namespace glissade
