#include "engine/planning/interactive/preferred_places.h"

#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {
namespace {

SamplingRegionPtr regionOf(const Problem& problem, const SemanticEditsPtr& edits) {
  const auto& knowledge = problem.scene.knowledge;
  if (!knowledge || !edits) return nullptr;
  const SemanticModel semantics = semanticsOf(problem, *knowledge, edits);
  const TopologicalMap& map = knowledge->environment->map;
  std::vector<std::size_t> cells;
  for (std::size_t place = 0; place < map.places.size(); ++place) {
    const double preference = std::get<double>(semantics.ofPlace(place, "preference").value);
    if (preference > 1.0) cells = unionOf(cells, map.places[place].cells);
  }
  return cells.empty() ? nullptr : std::make_shared<const SamplingRegion>(map.grid, std::move(cells));
}

}  // namespace

void PreferredPlaces::follow(const Problem& problem, const SemanticEditsPtr& edits) {
  if (edits == edits_) return;
  edits_ = edits;
  bounds_ = problem.bounds;
  region_ = regionOf(problem, edits);
}

Pose PreferredSampler::draw(const Box3& tree) {
  const SamplingRegionPtr& region = places_->current();
  drawnByOwn_ = !region || stream_.uniform() >= kShare;
  if (drawnByOwn_) return own_->draw(tree);
  return {region->sample(stream_, places_->bounds()), RandomShooter::orientation(stream_)};
}

}  // namespace glissade
