#include "engine/scenario/scenario_fits.h"

#include <nlohmann/json.hpp>

namespace glissade {
namespace {

double deflectionOf(const LoadedScenario& scenario, const std::string& id) {
  const auto known = scenario.deflections.find(id);
  return known == scenario.deflections.end() ? 0.0 : known->second;
}

}  // namespace

Outcome applyFits(LoadedScenario& scenario, const StopToken& stop) {
  scenario.fits = {};
  if (scenario.scenario.fits.on) {
    FitQuestion question{scenario.obstacles, scenario.object, {scenario.problem.start}, {}, scenario.scenario.fits};
    if (const Pose* goal = std::get_if<Pose>(&scenario.problem.goal)) question.ends.push_back(*goal);
    for (const RigidBody& body : scenario.obstacles) question.deflections.push_back(deflectionOf(scenario, body.id));
    question.deflections.push_back(deflectionOf(scenario, scenario.object.id));
    auto fits = findObjectFits(question, stop);
    if (!fits) {
      Diagnostic why = fits.error();
      why.file = scenario.file;
      return why;
    }
    scenario.fits = std::move(*fits);
  }
  scenario.problem.world = withFits(scenario.problem.world, scenario.fits.allowed);
  return Done{};
}

std::vector<ContactBody> contactBodiesOf(const LoadedScenario& scenario) {
  std::vector<ContactBody> bodies;
  for (const RigidBody& body : scenario.obstacles) {
    bodies.push_back({body.id, body.mesh, body.X_WB, deflectionOf(scenario, body.id)});
  }
  const RigidBody& object = scenario.object;
  bodies.push_back({object.id, object.mesh, object.X_WB, deflectionOf(scenario, object.id)});
  return bodies;
}

std::vector<std::string> allowancesInWords(const LoadedScenario& scenario) {
  std::vector<std::string> words;
  for (const Fit& fit : scenario.fits.allowed) {
    words.push_back(inWords(fit, scenario.object.name, scenario.obstacles[fit.obstacle].name));
  }
  return words;
}

nlohmann::ordered_json allowancesJson(const LoadedScenario& scenario) {
  auto list = nlohmann::ordered_json::array();
  for (const Fit& fit : scenario.fits.allowed) {
    const RigidBody& obstacle = scenario.obstacles[fit.obstacle];
    list.push_back({{"object", scenario.object.id},
                    {"body", obstacle.id},
                    {"kind", kindName(fit.kind)},
                    {"overlap_m", fit.overlap},
                    {"allowance_m", fit.allowance},
                    {"faces", "all"},
                    {"text", inWords(fit, scenario.object.name, obstacle.name)}});
  }
  return list;
}

}  // namespace glissade
