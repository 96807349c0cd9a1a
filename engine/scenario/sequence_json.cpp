#include "engine/scenario/sequence_json.h"

#include "engine/base/limits.h"

namespace glissade {
namespace {

using SequenceJson = JsonCursor::Json;

std::vector<std::string> readNames(const JsonCursor& at, std::size_t least) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) names.push_back(at.element(i).nonEmptyText());
  if (names.size() < least) at.fail("names less than " + std::to_string(least) + " bodies");
  return names;
}

Vector3 readGravity(const JsonCursor& at) {
  if (at.size() != 3) at.fail("is not three numbers");
  const Vector3 gravity(at.element(0).coordinate(), at.element(1).coordinate(), at.element(2).coordinate());
  if (!(gravity.norm() > 0.0)) at.fail("has no direction");
  return gravity;
}

}  // namespace

SequenceDemands readSequence(const JsonCursor& at) {
  at.allowOnly({"together", "before", "gravity", "densities"});
  SequenceDemands demands;
  const auto together = at.find("together");
  for (std::size_t i = 0; together && i < together->sizeUpTo(limits::kMostBodies); ++i) {
    demands.together.push_back(readNames(together->element(i), 2));
  }
  const auto before = at.find("before");
  for (std::size_t i = 0; before && i < before->sizeUpTo(limits::kMostBodies); ++i) {
    const auto names = readNames(before->element(i), 2);
    if (names.size() != 2) before->element(i).fail("is not two names");
    demands.before.emplace_back(names[0], names[1]);
  }
  if (const auto gravity = at.find("gravity")) demands.gravity = readGravity(*gravity);
  const auto densities = at.find("densities");
  for (std::size_t i = 0; densities && i < densities->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor density = densities->element(i);
    density.allowOnly({"body", "density"});
    demands.densities.emplace_back(density.at("body").nonEmptyText(), density.at("density").positiveNumber());
  }
  return demands;
}

void addSequence(const SequenceDemands& demands, SequenceJson& json) {
  if (demands == SequenceDemands()) return;
  SequenceJson section = SequenceJson::object();
  if (!demands.together.empty()) section["together"] = demands.together;
  for (const auto& [first, then] : demands.before) section["before"].push_back({first, then});
  if (demands.gravity != SequenceDemands().gravity) {
    section["gravity"] = {demands.gravity.x(), demands.gravity.y(), demands.gravity.z()};
  }
  for (const auto& [body, density] : demands.densities) {
    section["densities"].push_back({{"body", body}, {"density", density}});
  }
  json["sequence"] = std::move(section);
}

}  // namespace glissade
