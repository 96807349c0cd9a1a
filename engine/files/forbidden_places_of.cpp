#include "engine/files/forbidden_places_of.h"

#include "engine/files/scenario_io.h"
#include "engine/places/held_edits.h"
#include "engine/planning/coarse/prohibitions.h"

namespace glissade {

Result<ForbiddenPlaces> forbiddenPlacesOf(const LoadedScenario& loaded, const Scenario& content,
                                          const StopToken& stop) {
  Problem problem = loaded.problem;
  problem.scene.environment = content.environment;
  problem.scene.edits = std::make_shared<const SemanticEdits>(heldEdits(semanticEditsOf(content), loaded.product));
  problem.scene.knowledge = nullptr;
  const auto regions = Prohibitions().of(problem, stop);
  if (!regions) return regions.error();
  return *regions ? (*regions)->places() : ForbiddenPlaces{};
}

std::optional<Diagnostic> regionsWarning(const Scenario& scenario, const ForbiddenPlaces& places,
                                         const std::string& file) {
  if (scenario.forbiddenRegions == places) return std::nullopt;
  const bool missing = scenario.forbiddenRegions.empty();
  return Diagnostic{
      ErrorKind::MalformedInput, file, "/forbidden_regions",
      missing ? GLISSADE_TEXT("is missing, so that the file does not say where the forbidden places are")
              : GLISSADE_TEXT("is not where the forbidden places are"),
      GLISSADE_TEXT("Write it with glissade-cli info --save-regions, or save the scenario in the window.")};
}

Outcome addForbiddenPlaces(const std::string& scenarioFile, const StopToken& stop, check::Question& question) {
  if (!question.product.forbidsPlaces) return Done{};
  const auto loaded = loadScenario(scenarioFile, stop);
  if (!loaded) return loaded.error();
  const auto places = forbiddenPlacesOf(*loaded, loaded->scenario, stop);
  if (!places) return places.error();
  if (const auto warning = regionsWarning(loaded->scenario, *places, scenarioFile)) {
    question.product.warnings.push_back(*warning);
    for (const ForbiddenPlace& place : *places) question.forbidden.push_back({place.name, place.boxes});
  }
  question.product.forbidsPlaces = !question.forbidden.empty();
  return Done{};
}

}  // namespace glissade
