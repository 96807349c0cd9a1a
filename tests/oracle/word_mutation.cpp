#include "tests/oracle/word_mutation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {
namespace {

constexpr double kFullTurn = 6.283185307179586;

WordMutant falseMutant(const std::string& what) { return {what, MutantTruth::False}; }
WordMutant byWords(const std::string& what) { return {what, MutantTruth::ByWords}; }

Json& anyOf(Json& list, MutationDice& dice) { return list[dice.below(list.size())]; }

/// The motions of the steps from `first` on.
std::vector<Json*> motionsFrom(std::size_t first, Json& steps) {
  std::vector<Json*> motions;
  for (std::size_t i = first; i < steps.size(); ++i) {
    for (Json& motion : steps[i]["motions"]) motions.push_back(&motion);
  }
  return motions;
}

std::vector<Json*> motionsOf(Json& plan) { return motionsFrom(0, plan["steps"]); }

Json* anyOf(const std::vector<Json*>& motions, MutationDice& dice) {
  return motions.empty() ? nullptr : motions[dice.below(motions.size())];
}

/// A random motion that turns out of the thread of a joint; null if there is none.
Json* screwedMotion(Json& plan, MutationDice& dice) {
  std::vector<Json*> motions = motionsOf(plan);
  std::erase_if(motions, [](const Json* motion) {
    return motion->value("method", "") != "turned" || !motion->contains("joints");
  });
  return anyOf(motions, dice);
}

Json* motionWithAllowance(Json& plan, MutationDice& dice) {
  std::vector<Json*> motions = motionsOf(plan);
  std::erase_if(motions, [](Json* motion) { return (*motion)["allowances"].empty(); });
  return anyOf(motions, dice);
}

void scale(Json& number, double factor) { number = number.get<double>() * factor; }

WordMutant mutateCounts(Json& plan, MutationDice& dice) {
  const char* key = std::array<const char*, 3>{"apart", "parts", "removed"}[dice.below(3)];
  plan[key] = plan[key].get<std::size_t>() + 1 + dice.below(1000);
  return falseMutant(key);
}

WordMutant mutateCertificate(Json& plan, MutationDice& dice) {
  Json& steps = plan["steps"];
  const std::size_t at = dice.below(steps.size());
  Json& certificate = anyOf(steps[at]["motions"], dice)["certificate"];
  switch (dice.below(5)) {
    case 0: certificate["after_steps"] = at + 1 + dice.below(20); return falseMutant("after_steps");
    case 1: scale(certificate["required_m"], dice.magnitude(1.5, 1e4)); return falseMutant("required_m raised");
    case 2: scale(certificate["required_m"], dice.magnitude(1e-4, 0.7)); return falseMutant("required_m lowered");
    case 3:
      if (!certificate["min_clearance_m"].is_number() || !certificate["proved_clearance_m"].is_number()) break;
      certificate["min_clearance_m"] = certificate["proved_clearance_m"].get<double>() * dice.magnitude(1e-3, 0.7);
      return falseMutant("min_clearance_m");
    default:
      if (!certificate["proved_clearance_m"].is_number()) break;
      certificate["proved_clearance_m"] = 1e3 * dice.magnitude(1.0, 1e4);
      certificate["min_clearance_m"] = 1.1 * certificate["proved_clearance_m"].get<double>();
      return falseMutant("proved_clearance_m");
  }
  steps[at][dice.flip() ? "wave" : "task"] = 1'000'000 + dice.below(1000);
  return falseMutant("wave or task");
}

WordMutant mutateUnknownKeys(Json& plan, MutationDice& dice) {
  Json& step = anyOf(plan["steps"], dice);
  switch (dice.below(4)) {
    case 0: step["ends_outside"] = true; break;
    case 1: step["seconds"] = dice.uniform(1.0, 100.0); break;
    case 2: plan["wall_s"] = dice.uniform(1.0, 100.0); break;
    default:
      anyOf(step["motions"], dice)["tool"] = {
          {"kind", "socket"}, {"access", "free"}, {"size_m", dice.magnitude(1e-3, 10.0)}};
  }
  return falseMutant("a key that is not known");
}

WordMutant mutateJointNumbers(Json& plan, MutationDice& dice) {
  Json* motion = screwedMotion(plan, dice);
  if (motion == nullptr) return mutateCounts(plan, dice);
  Json& joint = anyOf((*motion)["joints"], dice);
  switch (dice.below(6)) {
    case 0: scale(joint["turns"], dice.magnitude(1.1, 1e3)); return falseMutant("turns raised");
    case 1: scale(joint["turns"], dice.magnitude(1e-3, 0.9)); return falseMutant("turns lowered");
    case 2: scale(joint["pitch_m"], dice.magnitude(1.1, 100.0)); return falseMutant("pitch_m raised");
    case 3: scale(joint["pitch_m"], -1.0); return falseMutant("pitch_m of the other hand");
    case 4: scale(joint["diameter_m"], dice.magnitude(1e2, 1e4)); return falseMutant("diameter_m");
    default: joint["bend_m"] = dice.magnitude(1e-5, 1e-2); return falseMutant("bend_m");
  }
}

WordMutant mutateDrive(Json& plan, MutationDice& dice) {
  for (Json* motion : motionsOf(plan)) {
    for (const Json& joint : motion->value("joints", Json::array())) {
      if (!joint.contains("drive_size_m")) continue;
      for (Json& each : (*motion)["joints"]) {
        if (each.contains("drive_size_m")) each["drive_size_m"] = dice.magnitude(1.0, 100.0);
      }
      return falseMutant("drive_size_m");
    }
  }
  return mutateCounts(plan, dice);
}

WordMutant mutateAllowanceNumbers(Json& plan, MutationDice& dice) {
  Json* motion = motionWithAllowance(plan, dice);
  if (motion == nullptr) return mutateCounts(plan, dice);
  Json& allowance = anyOf((*motion)["allowances"], dice);
  switch (dice.below(5)) {
    case 0:
      allowance["overlap_m"] = allowance["overlap_m"].get<double>() + dice.magnitude(1e-3, 1.0);
      return falseMutant("overlap_m");
    case 1: {
      if (!allowance.contains("evidence")) return mutateCounts(plan, dice);
      const char* key = std::array<const char*, 4>{"overlap_m", "deflection_m", "spacing_m", "margin_m"}[dice.below(4)];
      allowance["evidence"][key] = allowance["evidence"][key].get<double>() + dice.magnitude(1e-4, 1.0);
      return falseMutant(std::string("evidence ") + key);
    }
    case 2:
      allowance["evidence"]["by_person_m"] = dice.magnitude(1e-4, 1.0);
      for (const char* key : {"overlap_m", "deflection_m", "spacing_m", "margin_m"}) {
        if (!allowance["evidence"].contains(key)) allowance["evidence"][key] = 0.0;
      }
      return falseMutant("by_person_m");
    case 3: allowance["body"] = (*motion)["bodies"][0]; return falseMutant("host is the body itself");
    default: allowance["yields"] = !allowance.value("yields", false); return {"yields", MutantTruth::Unknown};
  }
}

/// Drops steps and makes their bodies staying ones, so that the base has several bodies.
WordMutant mutateBase(Json& plan, MutationDice& dice) {
  Json& steps = plan["steps"];
  if (steps.size() < 2) return mutateCounts(plan, dice);
  const std::size_t kept = 1 + dice.below(steps.size() - 1);
  for (const Json* motion : motionsFrom(kept, steps)) {
    for (const Json& body : (*motion)["bodies"]) plan["staying"].push_back(body);
  }
  while (steps.size() > kept) steps.erase(steps.size() - 1);
  const std::size_t removed = motionsOf(plan).size();
  for (const char* key : {"parts", "removed", "apart"}) plan[key] = removed;
  return byWords("base of several bodies");
}

/// Makes the last steps one step of a group, or of a unit that the plan states.
WordMutant mutateGroup(Json& plan, MutationDice& dice) {
  Json& steps = plan["steps"];
  if (steps.size() < 2) return mutateCounts(plan, dice);
  const std::size_t first = dice.below(steps.size() - 1);
  const bool isUnit = dice.flip();
  const std::vector<Json*> motions = motionsFrom(first, steps);
  std::vector<std::string> bodies;
  for (const Json* motion : motions) bodies.push_back((*motion)["bodies"][0]);
  Json group = *motions.back();
  std::rotate(bodies.begin(), bodies.end() - 1, bodies.end());
  group["bodies"] = bodies;
  group["certificate"] = {{"status", "certified"}};
  group.erase("joints");
  Json allowances = Json::array();
  for (const Json* motion : motions) {
    for (Json allowance : (*motion)["allowances"]) {
      const bool isInside = std::find(bodies.begin(), bodies.end(), allowance["body"]) != bodies.end();
      allowance["moving"] = (*motion)["bodies"][0];
      if (!isInside) allowances.push_back(allowance);
    }
  }
  group["allowances"] = allowances;
  if (isUnit) group["unit"] = true;
  Json step = steps.back();
  step["motions"] = Json::array({group});
  step.erase("after");
  while (steps.size() > first) steps.erase(steps.size() - 1);
  const std::size_t alone = motionsOf(plan).size();
  steps.push_back(step);
  plan["apart"] = isUnit ? alone + bodies.size() : alone;
  return byWords(isUnit ? "a unit of its own" : "a group that is not taken apart");
}

WordMutant mutateFlexible(Json& plan, MutationDice& dice) {
  Json& motion = anyOf(anyOf(plan["steps"], dice)["motions"], dice);
  motion["certificate"] = {{"status", "not_certified"}, {"after_steps", 0}};
  motion["allowances"] = Json::array();
  motion["joints"] = {{{"kind", "flexible"}, {"body", motion["bodies"][0]}, {"others", Json::array()}}};
  if (dice.flip()) {
    plan["sequence"]["joints"] = {{{"kind", "flexible"}, {"body", motion["bodies"][0]}, {"word", "confirmed"}}};
  }
  plan["certified"] = false;
  return byWords("a flexible body");
}

/// Adds a demand that the order does not keep; the step may state it or not.
WordMutant mutateDemand(Json& plan, MutationDice& dice) {
  Json& steps = plan["steps"];
  if (steps.size() < 2) return mutateCounts(plan, dice);
  const std::size_t earlier = dice.below(steps.size() - 1);
  const std::size_t later = earlier + 1 + dice.below(steps.size() - earlier - 1);
  const Json& late = steps[later]["motions"][0]["bodies"][0];
  plan["sequence"]["before"] = {{late, steps[earlier]["motions"][0]["bodies"][0]}};
  if (dice.below(3) == 0) return falseMutant("a broken demand");
  steps[earlier]["violates"] = {{{"rule", "before"}, {"bodies", {late}}}};
  return byWords("a demand that is given up");
}

Point positionOf(const Json& point) { return point["position"].get<Point>(); }

/// The rotation `q` (x y z w), followed by a turn by the angle about the unit axis.
Rotation turned(const Point& axis, double angle, const Rotation& q) {
  const double s = std::sin(0.5 * angle);
  const Rotation a{s * axis[0], s * axis[1], s * axis[2], std::cos(0.5 * angle)};
  return {a[3] * q[0] + a[0] * q[3] + a[1] * q[2] - a[2] * q[1], a[3] * q[1] - a[0] * q[2] + a[1] * q[3] + a[2] * q[0],
          a[3] * q[2] + a[0] * q[1] - a[1] * q[0] + a[2] * q[3], a[3] * q[3] - a[0] * q[0] - a[1] * q[1] - a[2] * q[2]};
}

/// Turns the body out with another pitch or in the other sense, or pulls it, as the plan's words allow.
WordMutant mutateThread(Json& plan, MutationDice& dice) {
  Json* motion = screwedMotion(plan, dice);
  if (motion == nullptr) return mutateCounts(plan, dice);
  Json& path = (*motion)["path"];
  const Json first = path.front();
  const Json last = path.back();
  Point way;
  for (std::size_t i = 0; i < 3; ++i) way[i] = positionOf(last)[i] - positionOf(first)[i];
  const double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
  for (double& each : way) each /= length;
  Json& joint = (*motion)["joints"][0];
  const double turnedAway = joint["turns"].get<double>() * std::abs(joint["pitch_m"].get<double>());
  const std::size_t kind = dice.below(4);
  double pitch = joint["pitch_m"].get<double>();
  if (kind == 0) pitch = -pitch;
  // The pitch is steeper than that of any standard thread of this diameter.
  if (kind == 1) pitch = joint["diameter_m"].get<double>() * dice.uniform(0.4, 0.48);
  const auto pointAt = [&](double advance, double turn) {
    Point position = positionOf(first);
    for (std::size_t i = 0; i < 3; ++i) position[i] += advance * way[i];
    return Json{{"position", position},
                {"orientation", turned(way, turn, first["orientation"].get<Rotation>())},
                {"author", "computer"}};
  };
  path = {first};
  if (kind <= 1) {
    const double turns = turnedAway / std::abs(pitch);
    const auto edges = static_cast<std::size_t>(std::ceil(turns * 4.0));
    for (std::size_t i = 1; i <= edges; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(edges);
      path.push_back(pointAt(share * turnedAway, share * turns * (pitch < 0.0 ? -kFullTurn : kFullTurn)));
    }
    const double whole = pitch < 0.0 ? -turns : turns;
    path.push_back(pointAt(length, whole * kFullTurn));
    for (Json& each : (*motion)["joints"]) {
      each["turns"] = turns;
      if (each.contains("pitch_m")) each["pitch_m"] = pitch;
    }
    return byWords(kind == 0 ? "a thread of the other hand" : "a thread of another pitch");
  }
  path.push_back(pointAt(length, 0.0));
  for (Json& each : (*motion)["joints"]) each["turns"] = 0.0;
  if (kind == 2) {
    plan["sequence"]["joint_use"] = "off";
    return byWords("pulled without joints");
  }
  plan["sequence"]["joints"] = Json::array();
  for (const Json& other : joint["others"]) {
    plan["sequence"]["joints"].push_back({{"kind", joint["kind"]},
                                          {"body", joint["body"]},
                                          {"others", {other}},
                                          {"word", dice.flip() ? "dissolved" : "pressed_out"}});
  }
  return byWords("pulled out of a joint that is dissolved");
}

/// Adds a bend that makes room although there is no hook.
WordMutant mutateBend(Json& plan, MutationDice& dice) {
  Json* motion = motionWithAllowance(plan, dice);
  if (motion == nullptr) return mutateCounts(plan, dice);
  Json& allowance = anyOf((*motion)["allowances"], dice);
  const double bend = dice.magnitude(1e-4, 5e-3);
  const Point from = positionOf((*motion)["path"].front());
  const Point to = positionOf((*motion)["path"].back());
  Point way;
  for (std::size_t i = 0; i < 3; ++i) way[i] = to[i] - from[i];
  plan["sequence"]["joints"] = {{{"kind", "snap"},
                                 {"body", (*motion)["bodies"][0]},
                                 {"others", {allowance["body"]}},
                                 {"word", "confirmed"},
                                 {"made", {{"point", from}, {"direction", way}, {"bend_m", bend}}}}};
  allowance["allowance_m"] = allowance["allowance_m"].get<double>() + bend;
  return byWords("a bend");
}

}  // namespace

WordMutant mutateWords(Json& plan, MutationDice& dice) {
  switch (dice.below(14)) {
    case 13: return {"clashes that nobody accepts", MutantTruth::ByWords, false};
    case 0: return mutateCounts(plan, dice);
    case 1: return mutateCertificate(plan, dice);
    case 2: return mutateUnknownKeys(plan, dice);
    case 3: return mutateJointNumbers(plan, dice);
    case 4: return mutateDrive(plan, dice);
    case 5:
    case 6: return mutateAllowanceNumbers(plan, dice);
    case 7: return mutateBase(plan, dice);
    case 8: return mutateGroup(plan, dice);
    case 9: return mutateFlexible(plan, dice);
    case 10: return mutateDemand(plan, dice);
    case 11: return mutateThread(plan, dice);
    default: return mutateBend(plan, dice);
  }
}

}  // namespace glissade::oracle
