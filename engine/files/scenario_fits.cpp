#include "engine/files/scenario_fits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/files/scenario_bodies.h"
#include "engine/fits/fit_thread.h"
#include "engine/fits/fit_words.h"
#include "engine/fits/fitted_world.h"

namespace glissade {
namespace {

/// Statements about the group's bodies and one other body, combined for the group.
struct GroupWord {
  FitEdit edit;
  std::size_t accepted = 0;  ///< number of its bodies for which a clash is accepted
};

void add(const FitEdit& said, GroupWord& word) {
  FitEdit& edit = word.edit;
  if (!edit.kind) edit.kind = said.kind;
  if (!edit.pitch) edit.pitch = said.pitch;
  if (said.allowance) edit.allowance = std::min(edit.allowance.value_or(*said.allowance), *said.allowance);
  word.accepted += said.accepted ? 1 : 0;
}

FitSettings fitsOfGroup(const FitSettings& fits, const std::vector<RigidBody>& group, const BodyId& groupId) {
  const auto isInGroup = [&group](const BodyId& id) {
    return std::any_of(group.begin(), group.end(), [&id](const RigidBody& body) { return body.id == id; });
  };
  FitSettings ofGroup = fits;
  ofGroup.pairs.clear();
  const evidence::FitWords said = wordsOf(fits);
  if (std::any_of(group.begin(), group.end(), [&](const RigidBody& body) { return said.isCut(body.id); }))
    ofGroup.cut.push_back(groupId.text());
  std::map<BodyId, GroupWord> words;  // statements by the other body
  for (const FitEdit& edit : fits.pairs) {
    const bool a = isInGroup(edit.a);
    if (a == isInGroup(edit.b)) {
      if (!a) ofGroup.pairs.push_back(edit);
      continue;
    }
    const BodyId& other = a ? edit.b : edit.a;
    GroupWord& word = words[other];
    word.edit.a = groupId;
    word.edit.b = other;
    if (word.edit.turned.empty() && !edit.turned.empty()) word.edit.turned = edit.turned == other ? other : groupId;
    add(edit, word);
  }
  for (auto& [other, word] : words) {
    word.edit.accepted = word.accepted == group.size();
    ofGroup.pairs.push_back(word.edit);
  }
  return ofGroup;
}

}  // namespace

AssembledProduct bodiesOf(const LoadedScenario& scenario) {
  AssembledProduct product;
  product.bodies = rigidBodiesOf(scenario);
  for (const RigidBody& body : product.bodies) {
    product.deflections.push_back(valueOf(scenario.deflections, body.id));
    product.spacings.push_back(valueOf(scenario.coordinateSpacings, body.id));
  }
  product.fits = scenario.scenario.fits;
  product.tree = scenario.product;
  return product;
}

AssembledProduct objectAndOthers(const LoadedScenario& scenario) {
  AssembledProduct product = bodiesOf(scenario);
  if (!scenario.scenario.object.isGroup()) return product;
  const std::size_t others = scenario.obstacles.size();
  product.bodies.resize(others);
  product.bodies.push_back(scenario.object);
  product.deflections.resize(others);
  product.spacings.resize(others);
  product.deflections.push_back(largestOf(scenario.deflections, scenario.objectBodies));
  product.spacings.push_back(largestOf(scenario.coordinateSpacings, scenario.objectBodies));
  product.fits = fitsOfGroup(scenario.scenario.fits, scenario.objectBodies, scenario.object.id);
  return product;
}

Outcome applyFits(LoadedScenario& scenario, const StopToken& stop) {
  scenario.fits = {};
  scenario.fitsPending = false;
  if (scenario.scenario.fits.on) {
    const AssembledProduct product = objectAndOthers(scenario);
    FitQuestion question{product, scenario.obstacles.size(), {scenario.problem.start}};
    if (const Pose* goal = std::get_if<Pose>(&scenario.problem.goal)) question.ends.push_back(*goal);
    question.world = scenario.problem.world;
    auto fits = findObjectFits(question, stop);
    if (!fits) {
      Diagnostic why = fits.error();
      why.file = scenario.file;
      return why;
    }
    scenario.fits = std::move(*fits);
  }
  scenario.problem.world = withFits(scenario.problem.world, scenario.object.mesh, scenario.fits.allowed);
  return Done{};
}

CollisionWorldPtr wholeWorld(const LoadedScenario& scenario) {
  return scenario.problem.world->updated(scenario.obstacles, scenario.object.mesh);
}

double turnsOn(const std::vector<PathPoint>& path, const LoadedScenario& scenario, const Fit& fit) {
  const std::vector<Pose> configurations = configurationsOf(path);
  for (const ThreadPair& pair : scenario.problem.world->threads()) {
    if (pair.rule().obstacle != static_cast<int>(fit.obstacle)) continue;
    return std::abs(turnsWhileEngaged(pair, configurations));
  }
  return 0.0;
}

std::vector<Message> allowancesInWords(const LoadedScenario& scenario, const std::vector<PathPoint>& path) {
  std::vector<Message> words;
  for (const Fit& fit : scenario.fits.allowed) {
    words.push_back(withTurns(inWords(fit, scenario.object.shown(), scenario.obstacles[fit.obstacle].shown()),
                              turnsOn(path, scenario, fit)));
  }
  return words;
}

nlohmann::ordered_json threadJson(const evidence::StatedThread& thread) {
  const auto numbers = [](const Vector3& v) { return std::array{v.x(), v.y(), v.z()}; };
  return {{"point_m", numbers(thread.point)},
          {"direction", numbers(thread.direction)},
          {"pitch_m", thread.pitch},
          {"radius_moving_m", thread.radiusMoving},
          {"radius_other_m", thread.radiusOther}};
}

nlohmann::ordered_json allowancesJson(const LoadedScenario& scenario, const std::vector<PathPoint>& path) {
  auto list = nlohmann::ordered_json::array();
  const std::vector<Message> words = allowancesInWords(scenario, path);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Fit& fit = scenario.fits.allowed[i];
    list.push_back({{"object", fit.moving},
                    {"body", fit.body},
                    {"kind", kContactKindNames.of(fit.kind)},
                    {"allowance_m", fit.allowance},
                    {"overlap_m", fit.evidence.overlap},
                    {"deflection_m", fit.evidence.deflection},
                    {"spacing_m", fit.evidence.spacing},
                    {"margin_m", fit.evidence.margin},
                    {"text", toString(words[i])}});
    if (fit.yields) list.back()["yields"] = true;
    if (fit.hollow) list.back()["hollow"] = true;
    if (fit.core) list.back()["core"] = threadJson(*fit.core);
    if (fit.evidence.byPerson > 0.0) list.back()["by_person_m"] = fit.evidence.byPerson;
    if (fit.pitch == 0.0) continue;
    list.back()["pitch_m"] = fit.pitch;
    if (!path.empty()) list.back()["turns"] = turnsOn(path, scenario, fit);
  }
  return list;
}

}  // namespace glissade
