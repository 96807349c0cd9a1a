#include "engine/files/plan_upgrade.h"

#include <algorithm>
#include <array>

namespace glissade {
namespace {

using Json = nlohmann::ordered_json;

/// Keys of version 1 that are of the step, not of its motion.
constexpr std::array<const char*, 4> kOfStep{"wave", "after", "violates", "task"};

bool isOfStep(const std::string& key) { return std::find(kOfStep.begin(), kOfStep.end(), key) != kOfStep.end(); }

/// The motion of a step of version 1.
Json motionOf(const Json& step) {
  if (!step.is_object()) return step;
  Json motion = Json::object();
  for (const auto& [key, value] : step.items()) {
    if (!isOfStep(key)) motion[key] = value;
  }
  return motion;
}

Json upgradedStep(const Json& step) {
  if (!step.is_object()) return step;
  Json upgraded = Json::object();
  for (const auto& [key, value] : step.items()) {
    if (isOfStep(key)) upgraded[key] = value;
  }
  upgraded["motions"] = Json::array({motionOf(step)});
  return upgraded;
}

void replaceEach(Json& object, const char* key, Json (*replaced)(const Json&)) {
  const auto list = object.find(key);
  if (list == object.end() || !list->is_array()) return;
  for (Json& each : *list) each = replaced(each);
}

/// Upgrades the steps of a plan or a line, and those of the lines below. The JSON reader limits the nesting.
void upgradeSteps(Json& list) {
  if (!list.is_object()) return;
  replaceEach(list, "steps", upgradedStep);
  const auto lines = list.find("lines");
  if (lines == list.end() || !lines->is_array()) return;
  for (Json& line : *lines) upgradeSteps(line);
}

}  // namespace

Json upgradedPlan(Json document) {
  upgradeSteps(document);
  replaceEach(document, "waiting", motionOf);
  document["version"] = 2;
  return document;
}

}  // namespace glissade
