#include "engine/planning/coarse/milestones.h"

#include <algorithm>

#include "engine/places/edit_binding.h"
#include "engine/planning/random_shooter.h"

namespace glissade {
namespace {

const Border& borderOf(const TopologicalMap& map, int border) { return map.borders[static_cast<std::size_t>(border)]; }

}  // namespace

MilestoneSampler::MilestoneSampler(const TopologicalMap& map, int border, std::uint64_t seed)
    : region_(map.grid, borderOf(map, border).cells), stream_(seed, "milestone of " + borderOf(map, border).name) {}

std::optional<Pose> MilestoneSampler::draw(CollisionQuery& query, const Box3& bounds) {
  const Vector3 position = region_.sample(stream_, bounds);
  const Pose q{position, RandomShooter::orientation(stream_)};
  if (query.collides(q)) return std::nullopt;
  return q;
}

std::optional<Pose> editedMilestone(const TopologicalMap& map, int border, const SemanticEdits& edits,
                                    CollisionQuery& query) {
  for (const MilestoneEdit& edit : edits.milestones) {
    const std::vector<int> borders = boundBorders(map, edit.at);
    const bool here = std::find(borders.begin(), borders.end(), border) != borders.end();
    if (here && !query.collides(edit.q)) return edit.q;
  }
  return std::nullopt;
}

namespace {

std::optional<Pose> fittedInPassage(const SceneKnowledge& knowledge, int place, int border) {
  const TopologicalMap& map = knowledge.environment->map;
  const auto p = static_cast<std::size_t>(place);
  const auto& crossing = knowledge.fits[p].crossing;
  if (!map.places[p].passage || !crossing) return std::nullopt;
  const int axis = map.places[p].axis;
  const bool lower = borderOf(map, border).centre[axis] < map.places[p].box.center()[axis];
  return lower ? crossing->before : crossing->behind;
}

}  // namespace

std::optional<Pose> fittedMilestone(const SceneKnowledge& knowledge, const TopologicalStep& step,
                                    const TopologicalStep* next) {
  if (step.border < 0) return std::nullopt;
  auto ahead = next != nullptr ? fittedInPassage(knowledge, next->place, step.border) : std::nullopt;
  auto here = fittedInPassage(knowledge, step.place, step.border);
  if (!ahead) return here;
  const auto margin = [&](int place) { return knowledge.fits[static_cast<std::size_t>(place)].margin; };
  return here && margin(step.place) < margin(next->place) ? here : ahead;
}

}  // namespace glissade
