#include "tests/oracle/json_mutation.h"

#include <algorithm>

namespace glissade::oracle {
namespace {

Json beyondLimits(MutationDice& dice) {
  switch (dice.below(6)) {
    case 0: return 1e300;
    case 1: return -1e300;
    case 2: return "NaN";
    case 3: return nullptr;
    case 4: return 1e9 * 1.01;
    default: return "1e-3";
  }
}

/// Shifts or turns a pose, sets numbers beyond limits, removes it, doubles it, or inserts one.
std::string mutatePoses(Json& poses, MutationDice& dice) {
  Json& pose = poses[dice.below(poses.size())];
  switch (dice.below(8)) {
    case 0:
    case 1: {
      const std::size_t axis = dice.below(3);
      pose["position"][axis] = pose["position"][axis].get<double>() + dice.either(dice.magnitude(1e-5, 0.1));
      return "pose shifted";
    }
    case 2: {
      const double half = dice.either(dice.magnitude(1e-4, 1.5));
      Json turn{0.0, 0.0, 0.0, std::cos(half)};
      turn[dice.below(3)] = std::sin(half);
      pose["orientation"] = turn;
      return "pose turned";
    }
    case 3: pose["position"][dice.below(3)] = beyondLimits(dice); return "position beyond limits";
    case 4:
      pose["orientation"][dice.below(4)] = dice.flip() ? beyondLimits(dice) : Json(0.7);
      return "orientation beyond limits";
    case 5: {
      Json added = pose;
      const std::size_t axis = dice.below(3);
      added["position"][axis] = added["position"][axis].get<double>() + dice.either(dice.magnitude(1e-4, 0.1));
      poses.insert(poses.begin() + static_cast<std::ptrdiff_t>(dice.below(poses.size() + 1)), added);
      return "pose added";
    }
    case 6: poses.erase(dice.below(poses.size())); return "pose dropped";
    default: std::reverse(poses.begin(), poses.end()); return "path reversed";
  }
}

Json inventedAllowance(const std::string& body, MutationDice& dice) {
  Json allowance{{"body", body}, {"allowance_m", dice.magnitude(1e-9, 1.0)}};
  if (dice.flip()) allowance["yields"] = dice.flip();
  return allowance;
}

/// `bodies`: bodies to which the allowance may be moved.
std::string mutateAllowances(Json& list, const std::vector<std::string>& bodies, MutationDice& dice) {
  const std::string& body = bodies[dice.below(bodies.size())];
  if (list.empty() || dice.below(5) == 0) {
    list.push_back(inventedAllowance(body, dice));
    if (dice.below(4) == 0) list.back()["pitch_m"] = 1e6;
    return "allowance invented";
  }
  Json& one = list[dice.below(list.size())];
  switch (dice.below(9)) {
    case 0: one["allowance_m"] = one["allowance_m"].get<double>() * dice.magnitude(1.1, 1e3); return "allowance raised";
    case 1: one["allowance_m"] = 1e-9; return "allowance made tiny";
    case 2: list = Json::array(); return "allowances emptied";
    case 3: one["body"] = dice.flip() ? body : "nobody"; return "allowance moved to another body";
    case 4: one["moving"] = dice.flip() ? body : "nobody"; return "allowance of another body";
    case 5: one["allowance_m"] = beyondLimits(dice); return "allowance beyond limits";
    case 6: one["allowance_m"] = -one["allowance_m"].get<double>(); return "allowance negative";
    case 7: one["pitch_m"] = dice.flip() ? Json(1e6) : beyondLimits(dice); return "pitch";
    default: list.push_back(inventedAllowance(one["body"].get<std::string>(), dice)); return "allowance stated twice";
  }
}

/// The first motion of a step.
Json& motionOf(Json& step) { return step["motions"][0]; }

std::size_t bodiesOf(const Json& step) {
  std::size_t bodies = 0;
  for (const Json& motion : step["motions"]) bodies += motion["bodies"].size();
  return bodies;
}

/// Removes a step, and reduces the numbers of steps in `after` that are beyond `from` by one.
void forgetStep(Json& steps, std::size_t from) {
  for (Json& step : steps) {
    if (!step.contains("after")) continue;
    Json kept = Json::array();
    for (const Json& each : step["after"]) {
      const auto number = each.get<std::size_t>();
      if (number != from + 1) kept.push_back(number > from + 1 ? number - 1 : number);
    }
    step["after"] = kept;
  }
}

std::string mutateSteps(Json& plan, const std::vector<std::string>& bodies, MutationDice& dice) {
  Json& steps = plan["steps"];
  const std::size_t at = dice.below(steps.size());
  switch (dice.below(8)) {
    case 0: steps.erase(at); return "step dropped";
    case 1:
    case 2: {
      const std::size_t removed = bodiesOf(steps[at]);
      forgetStep(steps, at);
      steps.erase(at);
      plan["removed"] = plan["removed"].get<std::size_t>() - removed;
      if (dice.flip()) plan["end"] = "stuck";
      return "step dropped, counts mended";
    }
    case 3: {
      const std::size_t other = dice.below(steps.size());
      for (const char* key : {"bodies", "path", "allowances"})
        std::swap(motionOf(steps[at])[key], motionOf(steps[other])[key]);
      return "steps swapped";
    }
    case 4: {
      const Json copy = steps[at];
      steps.push_back(copy);
      if (dice.flip()) plan["removed"] = plan["removed"].get<std::size_t>() + bodiesOf(copy);
      return "step doubled";
    }
    case 5: steps[at]["after"] = Json::array(); return "step after nothing";
    case 6:
      motionOf(steps[at])["bodies"] = {dice.below(4) == 0 ? "nobody" : bodies[dice.below(bodies.size())]};
      return "another body";
    default: steps[at]["after"].push_back(dice.below(steps.size() + 3)); return "after another step";
  }
}

std::string mutateClaims(Json& plan, const std::vector<std::string>& bodies, MutationDice& dice) {
  const std::string& body = bodies[dice.below(bodies.size())];
  Json& steps = plan["steps"];
  switch (dice.below(12)) {
    case 0: plan["parts"] = dice.below(12); return "parts";
    case 1: plan["removed"] = dice.below(12); return "removed";
    case 2: plan[dice.flip() ? "parts" : "removed"] = beyondLimits(dice); return "counts beyond limits";
    case 3: plan["staying"].push_back(dice.below(4) == 0 ? "nobody" : body); return "another body stays";
    case 4: plan["staying"] = plan["bodies"]; return "all bodies stay";
    case 5: plan["bodies"].erase(dice.below(plan["bodies"].size())); return "body not listed";
    case 6: plan["bodies"].push_back(dice.flip() ? "nobody" : body); return "body listed";
    case 7:
      plan["steps"] = Json::array();
      plan["removed"] = 0;
      return "no steps";
    case 8: plan["certified"] = false; return "not certified";
    case 9:
      motionOf(steps[dice.below(steps.size())])["certificate"]["status"] = dice.flip() ? "violated" : "undecided";
      return "status";
    case 10: plan["deflection_m"] = dice.flip() ? Json(0.02) : beyondLimits(dice); return "deflection";
    default: plan["end"] = dice.flip() ? "stuck" : "finished"; return "end";
  }
}

}  // namespace

std::string mutatePath(Json& path, const std::string& body, MutationDice& dice) {
  if (dice.flip()) return mutatePoses(path["configurations"], dice);
  return mutateAllowances(path["allowances"], {body, "object"}, dice);
}

std::string mutatePlan(Json& plan, const std::vector<std::string>& bodies, MutationDice& dice) {
  Json& motion = motionOf(plan["steps"][dice.below(plan["steps"].size())]);
  switch (dice.below(4)) {
    case 0: return mutatePoses(motion["path"], dice);
    case 1: return mutateAllowances(motion["allowances"], bodies, dice);
    case 2: return mutateSteps(plan, bodies, dice);
    default: return mutateClaims(plan, bodies, dice);
  }
}

}  // namespace glissade::oracle
