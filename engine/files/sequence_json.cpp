#include "engine/files/sequence_json.h"

#include "engine/base/limits.h"
#include "engine/files/body_classes_json.h"
#include "engine/files/joints_json.h"
#include "engine/files/semantics_json.h"
#include "engine/geometry/pose_json.h"
#include "engine/sequence/fastener_kind.h"

namespace glissade {
namespace {

using SequenceJson = JsonCursor::Json;

std::vector<std::string> readNames(const JsonCursor& at, std::size_t least) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) names.push_back(at.element(i).nonEmptyText());
  if (names.size() < least) at.fail({GLISSADE_TEXT("names fewer than %1 bodies"), {least}});
  return names;
}

Vector3 readDirection(const JsonCursor& at) {
  if (at.size() != 3) at.fail(GLISSADE_TEXT("is not three numbers"));
  const Vector3 gravity(at.element(0).coordinate(), at.element(1).coordinate(), at.element(2).coordinate());
  if (!(gravity.norm() > 0.0)) at.fail(GLISSADE_TEXT("has no direction"));
  return gravity;
}

/// Reads [[body, text], ...].
std::vector<std::pair<std::string, std::string>> readPairs(const std::optional<JsonCursor>& at) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (std::size_t i = 0; at && i < at->sizeUpTo(limits::kMostBodies); ++i) {
    const auto names = readNames(at->element(i), 2);
    if (names.size() != 2) at->element(i).fail(GLISSADE_TEXT("is not two texts"));
    pairs.emplace_back(names[0], names[1]);
  }
  return pairs;
}

void readKnowledge(const JsonCursor& at, SequenceDemands& demands) {
  if (const auto stay = at.find("stay")) demands.stay = readNames(*stay, 0);
  if (const auto fragile = at.find("fragile")) demands.fragile = readNames(*fragile, 0);
  const auto masses = at.find("masses");
  for (std::size_t i = 0; masses && i < masses->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor mass = masses->element(i);
    mass.allowOnly({"body", "mass"});
    demands.masses.emplace_back(mass.at("body").nonEmptyText(), mass.at("mass").positiveNumber());
  }
  demands.tools = readPairs(at.find("tools"));
  demands.fasteners = readPairs(at.find("fasteners"));
  for (std::size_t i = 0; i < demands.fasteners.size(); ++i) {
    if (!kFastenerNames.find(demands.fasteners[i].second)) {
      at.at("fasteners")
          .element(i)
          .fail({GLISSADE_TEXT("names a fastener that is not one of: %1"), {kFastenerNames.listed()}});
    }
  }
  if (const auto cost = at.find("cost")) demands.cost = cost->nonEmptyText();
  if (const auto attributes = at.find("attributes")) {
    attributes->expectObject();
    for (const auto& item : attributes->json().items()) {
      demands.attributes[item.key()] = readAttributes(attributes->find(item.key()));
    }
  }
  if (const auto classes = at.find("classes")) demands.classes = readBodyClasses(*classes);
}

/// Reads a person's edits of steps.
void readSteps(const JsonCursor& at, SequenceDemands& demands) {
  const auto places = at.find("places");
  for (std::size_t i = 0; places && i < places->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor place = places->element(i);
    place.allowOnly({"bodies", "place", "locked"});
    demands.places.push_back({readNames(place.at("bodies"), 1)});
    demands.places.back().place = static_cast<std::size_t>(place.at("place").wholeNumber());
    if (demands.places.back().place == 0) place.at("place").fail(GLISSADE_TEXT("is not 1 or more"));
    if (const auto locked = place.find("locked")) demands.places.back().locked = locked->boolean();
  }
  const auto motions = at.find("motions");
  for (std::size_t i = 0; motions && i < motions->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor motion = motions->element(i);
    motion.allowOnly({"bodies", "method", "path"});
    demands.motions.push_back(
        {readNames(motion.at("bodies"), 1), readMotion(motion.at("path")), motion.at("method").nonEmptyText()});
    if (demands.motions.back().path.size() < 2)
      motion.at("path").fail(GLISSADE_TEXT("has fewer than two configurations"));
  }
  const auto forbidden = at.find("forbidden");
  for (std::size_t i = 0; forbidden && i < forbidden->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor direction = forbidden->element(i);
    direction.allowOnly({"body", "direction"});
    demands.forbidden.push_back({direction.at("body").nonEmptyText(), readDirection(direction.at("direction"))});
  }
}

void addSteps(const SequenceDemands& demands, SequenceJson& section) {
  for (const DemandedPlace& each : demands.places) {
    SequenceJson place{{"bodies", each.bodies}, {"place", each.place}};
    if (each.locked) place["locked"] = true;
    section["places"].push_back(std::move(place));
  }
  for (const DemandedMotion& each : demands.motions) {
    section["motions"].push_back({{"bodies", each.bodies}, {"method", each.method}, {"path", motionJson(each.path)}});
  }
  for (const ForbiddenDirection& each : demands.forbidden) {
    const Vector3& way = each.direction;
    section["forbidden"].push_back({{"body", each.body}, {"direction", {way.x(), way.y(), way.z()}}});
  }
}

void addKnowledge(const SequenceDemands& demands, SequenceJson& section) {
  if (!demands.stay.empty()) section["stay"] = demands.stay;
  for (const auto& [body, mass] : demands.masses) section["masses"].push_back({{"body", body}, {"mass", mass}});
  if (!demands.fragile.empty()) section["fragile"] = demands.fragile;
  for (const auto& [body, tool] : demands.tools) section["tools"].push_back({body, tool});
  for (const auto& [body, kind] : demands.fasteners) section["fasteners"].push_back({body, kind});
  if (!demands.cost.empty()) section["cost"] = demands.cost;
  for (const auto& [body, attributes] : demands.attributes) section["attributes"][body] = attributesToJson(attributes);
  for (const BodyClass& each : demands.classes) section["classes"].push_back(toJson(each));
}

}  // namespace

std::vector<PathPoint> readMotion(const JsonCursor& at) {
  constexpr std::size_t kMostConfigurations = 1'000'000;
  std::vector<PathPoint> path;
  for (std::size_t i = 0; i < at.sizeUpTo(kMostConfigurations); ++i) {
    const JsonCursor point = at.element(i);
    point.allowOnly({"position", "orientation", "author"});
    const SequenceJson pose{{"position", point.at("position").json()}, {"orientation", point.at("orientation").json()}};
    path.push_back({readPose(JsonCursor(pose, at.file(), at.pointer() + "/" + std::to_string(i))),
                    point.at("author").named(kAuthorNames)});
  }
  if (path.empty()) at.fail(GLISSADE_TEXT("is empty"), GLISSADE_TEXT("Give a path."));
  return path;
}

SequenceJson motionJson(const std::vector<PathPoint>& path) {
  SequenceJson json = SequenceJson::array();
  for (const PathPoint& point : path) {
    SequenceJson configuration = toJson(point.q);
    configuration["author"] = kAuthorNames.of(point.author);
    json.push_back(std::move(configuration));
  }
  return json;
}

SequenceDemands readSequence(const JsonCursor& at) {
  at.allowOnly({"together", "before", "gravity", "densities", "stay", "masses", "fragile", "tools", "fasteners", "cost",
                "attributes", "classes", "places", "motions", "forbidden", "joint_use", "joints"});
  SequenceDemands demands;
  const auto together = at.find("together");
  for (std::size_t i = 0; together && i < together->sizeUpTo(limits::kMostBodies); ++i) {
    demands.together.push_back(readNames(together->element(i), 2));
  }
  const auto before = at.find("before");
  for (std::size_t i = 0; before && i < before->sizeUpTo(limits::kMostBodies); ++i) {
    const auto names = readNames(before->element(i), 2);
    if (names.size() != 2) before->element(i).fail(GLISSADE_TEXT("is not two names"));
    demands.before.emplace_back(names[0], names[1]);
  }
  if (const auto gravity = at.find("gravity")) demands.gravity = readDirection(*gravity);
  const auto densities = at.find("densities");
  for (std::size_t i = 0; densities && i < densities->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor density = densities->element(i);
    density.allowOnly({"body", "density"});
    demands.densities.emplace_back(density.at("body").nonEmptyText(), density.at("density").positiveNumber());
  }
  if (const auto use = at.find("joint_use")) demands.jointUse = use->named(kJointUseNames);
  if (const auto joints = at.find("joints")) demands.joints = readJointEdits(*joints);
  readKnowledge(at, demands);
  readSteps(at, demands);
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
  if (demands.jointUse != SequenceDemands().jointUse) section["joint_use"] = kJointUseNames.of(demands.jointUse);
  addJointEdits(demands.joints, section);
  addKnowledge(demands, section);
  addSteps(demands, section);
  json["sequence"] = std::move(section);
}

}  // namespace glissade
