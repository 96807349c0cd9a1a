#include "engine/files/scenario_bodies.h"

#include <algorithm>

#include "engine/files/scenario_product.h"

namespace glissade {
namespace {

void addAll(const std::vector<BodyDescription>& bodies, std::vector<const BodyDescription*>& all) {
  for (const BodyDescription& body : bodies) all.push_back(&body);
}

}  // namespace

std::vector<const BodyDescription*> presentBodiesOf(const Scenario& scenario) {
  std::vector<const BodyDescription*> all;
  addAll(scenario.bodies, all);
  addAll(scenario.object.bodies, all);
  return all;
}

std::vector<const BodyDescription*> allBodiesOf(const Scenario& scenario) {
  std::vector<const BodyDescription*> all = presentBodiesOf(scenario);
  addAll(scenario.leftOut, all);
  return all;
}

std::vector<std::string> shownLeftOut(const Scenario& scenario) {
  std::vector<std::string> ids;
  for (const BodyDescription* body : allBodiesOf(scenario)) ids.push_back(body->id.text());
  const std::vector<std::string> shown = treeOf(scenario).labels(ids);
  return {shown.end() - static_cast<std::ptrdiff_t>(scenario.leftOut.size()), shown.end()};
}

std::vector<const Geometry*> geometriesOf(const Scenario& scenario) {
  std::vector<const Geometry*> geometries;
  for (const BodyDescription* body : presentBodiesOf(scenario)) geometries.push_back(&body->geometry);
  return geometries;
}

std::vector<std::string> nodeIdsOf(const Scenario& scenario) {
  const Product product = treeOf(scenario);
  std::vector<std::string> ids;
  for (const Product::Node& node : product.nodes()) ids.push_back(node.id);
  return ids;
}

std::string idOf(const ObjectDescription& object) {
  std::string id;
  for (const BodyDescription& body : object.bodies) id += (id.empty() ? "" : "+") + body.id.text();
  return id;
}

bool isInObject(const LoadedScenario& loaded, const BodyId& rigidId) {
  return std::any_of(loaded.objectBodies.begin(), loaded.objectBodies.end(),
                     [&](const RigidBody& body) { return body.id == rigidId; });
}

double valueOf(const std::map<BodyId, double>& values, const BodyId& id) {
  const auto known = values.find(id);
  return known == values.end() ? 0.0 : known->second;
}

double largestOf(const std::map<BodyId, double>& values, const std::vector<RigidBody>& bodies) {
  double largest = 0.0;
  for (const RigidBody& body : bodies) largest = std::max(largest, valueOf(values, body.id));
  return largest;
}

std::vector<RigidBody> rigidBodiesOf(const LoadedScenario& loaded) {
  std::vector<RigidBody> bodies = loaded.obstacles;
  bodies.insert(bodies.end(), loaded.objectBodies.begin(), loaded.objectBodies.end());
  return bodies;
}

const RigidBody& rigidBodyAt(std::size_t body, const LoadedScenario& loaded) {
  const std::size_t others = loaded.obstacles.size();
  return body < others ? loaded.obstacles[body] : loaded.objectBodies[body - others];
}

}  // namespace glissade
