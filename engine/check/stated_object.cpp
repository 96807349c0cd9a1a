#include "engine/check/stated_object.h"

#include <algorithm>
#include <map>

#include "engine/import/geometry_loader.h"

namespace glissade::check {
namespace {

/// The reference point in the frame of the first body's geometry.
Vector3 referenceOf(const StatedScenario& scenario, const ObjectGeometry& geometry) {
  return scenario.centreOnVertexMean ? geometry.front()->vertexMean : scenario.referencePoint;
}

Pose poseInObject(const StatedScenario& scenario, std::size_t body) {
  return body == 0 ? Pose::identity() : unitRotation(scenario.object[body].pose);
}

/// The statements about the pairs of a group with one other body, merged into one.
struct GroupWord {
  PairWord word;
  std::size_t accepted = 0;  ///< number of bodies of the group for which a clash is accepted
};

}  // namespace

Pose unitRotation(const Pose& pose) { return {pose.position, pose.orientation.normalized()}; }

void addParts(const StatedScenario::StatedBody& stated, const LoadedGeometry& geometry, std::vector<Body>& bodies) {
  for (const Occurrence& part : geometry.parts) {
    Body body;
    body.id = partId(stated.id, part);
    body.name = part.path.empty() ? stated.name : part.path;
    body.mesh = part.mesh;
    body.X_WB = unitRotation(stated.pose) * part.X_FP;
    body.spacing = part.coordinateSpacing;
    body.deflection = part.deflection;
    bodies.push_back(std::move(body));
  }
}

Body objectOf(const StatedScenario& scenario, const ObjectGeometry& geometry) {
  const StatedScenario::StatedBody& first = scenario.object.front();
  Body object{first.id, first.name, nullptr, unitRotation(scenario.start)};
  const Vector3 reference = referenceOf(scenario, geometry);
  TriangleMesh mesh = wholeMesh(*geometry.front(), reference);
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    for (const Occurrence& part : geometry[i]->parts) {
      object.spacing = std::max(object.spacing, part.coordinateSpacing);
      object.deflection = std::max(object.deflection, part.deflection);
    }
    if (i == 0) continue;
    const Pose X_OB = Pose::translation(-reference) * poseInObject(scenario, i);
    append(mesh, transformed(wholeMesh(*geometry[i], Vector3::Zero()), X_OB));
  }
  object.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return object;
}

std::vector<Body> groupBodiesOf(const StatedScenario& scenario, const ObjectGeometry& geometry) {
  const Pose X_WG = unitRotation(scenario.start) * Pose::translation(-referenceOf(scenario, geometry));
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    StatedScenario::StatedBody placed = scenario.object[i];
    placed.pose = X_WG * poseInObject(scenario, i);
    addParts(placed, *geometry[i], bodies);
  }
  return bodies;
}

FitWords wordsOfGroup(const FitWords& fits, const std::vector<Body>& group, const BodyId& groupId) {
  const auto isInGroup = [&group](const BodyId& id) {
    return std::any_of(group.begin(), group.end(), [&id](const Body& body) { return body.id == id; });
  };
  FitWords ofGroup{fits.on, fits.acceptedClash, {}};
  ofGroup.cut = fits.cut;
  const bool isCut = std::any_of(group.begin(), group.end(), [&](const Body& body) { return fits.isCut(body.id); });
  if (isCut) ofGroup.cut.push_back(groupId.text());
  std::map<BodyId, GroupWord> words;  // keyed by the other body
  for (const PairWord& said : fits.pairs) {
    if (isInGroup(said.a) && isInGroup(said.b)) continue;
    if (!isInGroup(said.a) && !isInGroup(said.b)) {
      ofGroup.pairs.push_back(said);
      continue;
    }
    const BodyId& other = isInGroup(said.a) ? said.b : said.a;
    GroupWord& known = words[other];
    PairWord& word = known.word;
    word.a = groupId;
    word.b = other;
    if (word.kind.empty()) word.kind = said.kind;
    if (!word.pitch) word.pitch = said.pitch;
    if (word.turned.empty() && !said.turned.empty()) word.turned = said.turned == other ? other : groupId;
    if (said.allowance) word.allowance = std::min(word.allowance.value_or(*said.allowance), *said.allowance);
    known.accepted += said.accepted ? 1 : 0;
  }
  for (auto& [other, known] : words) {
    known.word.accepted = known.accepted == group.size();
    ofGroup.pairs.push_back(known.word);
  }
  return ofGroup;
}

}  // namespace glissade::check
