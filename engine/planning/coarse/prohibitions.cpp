#include "engine/planning/coarse/prohibitions.h"

#include "engine/base/tolerances.h"
#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

Result<EnvironmentModelPtr> Prohibitions::placesOf(const Problem& problem, const StopToken& stop) {
  if (problem.scene.knowledge) return problem.scene.knowledge->environment;
  if (found_ && foundWith_ == problem.scene.edits->bodies) return found_;
  auto built = buildEnvironmentOf(problem, stop);
  if (!built) return built.error();
  found_ = std::move(*built);
  foundWith_ = problem.scene.edits->bodies;
  return found_;
}

Result<ForbiddenRegionsPtr> Prohibitions::of(const Problem& problem, const StopToken& stop) {
  const SemanticEditsPtr& edits = problem.scene.edits;
  if (!edits || !forbidsPlaces(*edits)) return ForbiddenRegionsPtr();
  const auto environment = placesOf(problem, stop);
  if (!environment) return environment.error();
  auto places = forbiddenPlacesOf((*environment)->map, *edits);
  if (!places) return places.error();
  if (places->empty()) return ForbiddenRegionsPtr();
  const double margin = tolerance::kForbiddenMargin * problem.world->objectRadius();
  return std::make_shared<const ForbiddenRegions>(std::move(*places), margin);
}

Result<Problem> keepingOut(Problem problem, const StopToken& stop) {
  auto regions = Prohibitions().of(problem, stop);
  if (!regions) return regions.error();
  if (!*regions) return problem;
  const auto space = std::make_shared<ForbiddenSpace>();
  space->set(std::move(*regions));
  problem.world = problem.world->withForbidden(space);
  return problem;
}

std::optional<std::string> firstForbidden(const std::vector<Pose>& path, const ForbiddenRegions& regions) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose& to = path[std::min(i + 1, path.size() - 1)];
    if (const auto stretch = regions.firstOn(path[i].position, to.position))
      return regions.places()[stretch->place].name;
  }
  return std::nullopt;
}

}  // namespace glissade
