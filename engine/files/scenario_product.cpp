#include "engine/files/scenario_product.h"

#include <algorithm>
#include <set>

#include "engine/files/scenario_bodies.h"
#include "engine/import/step_import.h"

namespace glissade {

bool isAboutProduct(const Scenario& scenario) {
  const auto isCad = [](const Asset& asset) { return isCadFile(asset.path); };
  return std::holds_alternative<GoalOut>(scenario.goal) ||
         std::any_of(scenario.assets.begin(), scenario.assets.end(), isCad);
}

Product treeOf(const Scenario& scenario, const BodyGeometry& geometry) {
  std::vector<ProductBody> bodies;
  for (const BodyDescription* body : allBodiesOf(scenario)) {
    bodies.push_back({body->id, {body->name}});
    const auto loaded = geometry.find(body->id);
    if (loaded == geometry.end()) continue;
    const std::vector<Occurrence>& parts = loaded->second->parts;
    const bool isOne = !scenario.object.isGroup() && body == &scenario.object.bodies.front();
    if (isOne && !parts.empty()) bodies.back().place.unit = parts.front().unit;
    if (isOne) continue;
    for (const Occurrence& part : parts) bodies.back().parts.push_back({part.path, part.names, part.unit});
  }
  return Product(bodies, scenario.nodes);
}

Outcome checkNodes(const Scenario& scenario) {
  if (scenario.nodes.empty()) return Done{};
  const Product product = treeOf(scenario);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < scenario.nodes.size(); ++i) {
    const NodeDescription& said = scenario.nodes[i];
    const std::string pointer = "/product/" + std::to_string(i);
    const auto wrong = [&](const std::string& key, const Message& reason, const Message& advice) {
      return Diagnostic{ErrorKind::MalformedInput, "", pointer + "/" + key, reason, advice};
    };
    if (!seen.insert(said.id).second) {
      return wrong("id", {GLISSADE_TEXT("has the id '%1' a second time"), {said.id}},
                   GLISSADE_TEXT("Say all of a node at one place."));
    }
    const auto node = product.find(said.id);
    if (!node)
      return wrong("id", GLISSADE_TEXT("is neither a body nor an assembly of this product"),
                   GLISSADE_TEXT("Correct the id."));
    const Product::Node& made = product.nodes()[*node];
    if (!made.isAssembly && !said.attributes.empty()) {
      return wrong("attributes", GLISSADE_TEXT("is about a body, which has its attributes itself"),
                   GLISSADE_TEXT("Write them there."));
    }
    if (!said.in) continue;
    const std::string parent = made.parent ? product.nodes()[*made.parent].id : "";
    const bool isThere = said.in->empty() || (made.parent && product.nodes()[*made.parent].isAssembly);
    if (parent != *said.in || !isThere) {
      return wrong("in", GLISSADE_TEXT("is no assembly that the node can be in"),
                   GLISSADE_TEXT("Name an assembly that is not below it."));
    }
  }
  return Done{};
}

void dropUnknownNodes(Scenario& scenario) {
  if (scenario.nodes.empty()) return;
  const Product product = treeOf(scenario);
  std::erase_if(scenario.nodes, [&](const NodeDescription& node) { return !product.find(node.id); });
}

}  // namespace glissade
