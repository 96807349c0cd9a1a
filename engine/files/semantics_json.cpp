#include "engine/files/semantics_json.h"

#include "engine/base/limits.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_product.h"
#include "engine/geometry/pose_json.h"
#include "engine/planning/planner.h"

namespace glissade {

using Json = JsonCursor::Json;

namespace {

/// More cells than this are in no topological layer.
constexpr std::size_t kMostBoxes = 4'000'000;

Box3 readBox(const JsonCursor& at) {
  if (at.size() != 6)
    at.fail(GLISSADE_TEXT("is not a box"),
            GLISSADE_TEXT("Give six coordinates: the least x, y and z, then the largest."));
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min()[axis] = at.element(static_cast<std::size_t>(axis)).coordinate();
    box.max()[axis] = at.element(static_cast<std::size_t>(axis) + 3).coordinate();
  }
  if (box.isEmpty())
    at.fail(GLISSADE_TEXT("is not a box"),
            GLISSADE_TEXT("Give six coordinates: the least x, y and z, then the largest."));
  return box;
}

/// Reads the boxes of forbidden places, which a scenario file states beside the edits that forbid them. A reader
/// without an environment model uses them. Private to the readers and writers of this module. Reading throws JsonError.
void readForbiddenRegions(const JsonCursor& root, Scenario& scenario) {
  const auto regions = root.find("forbidden_regions");
  for (std::size_t i = 0; regions && i < regions->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor region = regions->element(i);
    region.allowOnly({"place", "boxes"});
    ForbiddenPlace place{region.at("place").nonEmptyText(), {}};
    const JsonCursor boxes = region.at("boxes");
    for (std::size_t box = 0; box < boxes.sizeUpTo(kMostBoxes); ++box)
      place.boxes.push_back(readBox(boxes.element(box)));
    scenario.forbiddenRegions.push_back(std::move(place));
  }
}

/// Adds "forbidden_regions" where there are some.
void addForbiddenRegions(const ForbiddenPlaces& places, JsonCursor::Json& json) {
  if (places.empty()) return;
  auto& regions = json["forbidden_regions"] = JsonCursor::Json::array();
  for (const ForbiddenPlace& place : places) {
    auto boxes = JsonCursor::Json::array();
    for (const Box3& box : place.boxes) {
      const Vector3& least = box.min();
      const Vector3& most = box.max();
      boxes.push_back({least.x(), least.y(), least.z(), most.x(), most.y(), most.z()});
    }
    regions.push_back({{"place", place.name}, {"boxes", std::move(boxes)}});
  }
}

/// Most choices of an attribute, because they are searched sequentially.
constexpr std::size_t kMostChoices = 1000;
/// Most rules of a strategy, because they are tried sequentially.
constexpr std::size_t kMostRules = 1000;

AttributeValue readValue(const JsonCursor& at) {
  if (at.json().is_boolean()) return at.boolean();
  if (at.isString()) return at.text();
  return at.number();
}

}  // namespace

Attributes readAttributes(const std::optional<JsonCursor>& at) {
  Attributes attributes;
  if (!at) return attributes;
  if (!at->json().is_object()) at->fail(GLISSADE_TEXT("is not an object"));
  for (const auto& item : at->json().items()) {
    attributes[item.key()] = readValue(at->at(item.key()));
  }
  return attributes;
}

EnvironmentOptions readEnvironmentOptions(const JsonCursor& at) {
  at.allowOnly({"cell_size", "memory", "topology_level", "places"});
  EnvironmentOptions options;
  if (const auto size = at.find("cell_size")) {
    options.cellSize = size->coordinate();
    if (options.cellSize < 0.0)
      size->fail(GLISSADE_TEXT("is below zero"), GLISSADE_TEXT("Give metres, or 0 for as fine as the memory allows."));
  }
  if (const auto memory = at.find("memory")) options.memory = memory->positiveNumber();
  if (const auto level = at.find("topology_level")) {
    const std::uint64_t value = level->wholeNumber();
    if (value < 2 || value > 8) level->fail(GLISSADE_TEXT("is out of range"), GLISSADE_TEXT("Give 2 to 8."));
    options.topologyLevel = static_cast<int>(value);
  }
  if (const auto places = at.find("places")) {
    options.identifier = places->text();
    if (makePlaceIdentifierRegistry().find(options.identifier) == nullptr) {
      places->fail(GLISSADE_TEXT("names no way to find places"), GLISSADE_TEXT("Give region-growing or watershed."));
    }
  }
  return options;
}

namespace {

AttributeDefinition readDefinition(const JsonCursor& at) {
  at.allowOnly({"name", "label", "type", "of", "unit", "minimum", "maximum", "choices", "description", "initial"});
  AttributeDefinition definition;
  definition.name = at.at("name").nonEmptyText();
  definition.label = Message(at.has("label") ? at.at("label").text() : definition.name);
  definition.type = at.at("type").named(kAttributeTypeNames);
  definition.owner = at.at("of").named(kAttributeOwnerNames);
  if (const auto unit = at.find("unit")) definition.unit = unit->text();
  if (const auto minimum = at.find("minimum")) definition.minimum = minimum->number();
  if (const auto maximum = at.find("maximum")) definition.maximum = maximum->number();
  const auto choices = at.find("choices");
  for (std::size_t i = 0; choices && i < choices->sizeUpTo(kMostChoices); ++i) {
    definition.choices.push_back(choices->element(i).nonEmptyText());
  }
  if (const auto description = at.find("description")) definition.description = Message(description->text());
  definition.initial = initialValue(definition);
  if (const auto initial = at.find("initial")) definition.initial = readValue(*initial);
  return definition;
}

PlaceEdit readPlace(const JsonCursor& at) {
  at.allowOnly({"at", "name", "attributes"});
  PlaceEdit edit;
  edit.at = readVector(at.at("at"));
  if (const auto name = at.find("name")) edit.name = name->text();
  edit.attributes = readAttributes(at.find("attributes"));
  return edit;
}

MilestoneEdit readMilestone(const JsonCursor& at) {
  at.allowOnly({"at", "pose"});
  return {readVector(at.at("at")), readPose(at.at("pose"))};
}

StrategyRules readRules(const JsonCursor& at) {
  at.allowOnly({"node", "edge", "fine", "loop", "fitted"});
  StrategyRules rules;
  rules.node = at.at("node").nonEmptyText();
  rules.edge = at.at("edge").nonEmptyText();
  const JsonCursor fine = at.at("fine");
  for (std::size_t i = 0; i < fine.sizeUpTo(kMostRules); ++i) {
    const JsonCursor rule = fine.element(i);
    rule.allowOnly({"when", "geometrical", "local"});
    rules.fine.push_back({rule.at("when").nonEmptyText(), rule.has("geometrical") && rule.at("geometrical").boolean(),
                          rule.at("local").nonEmptyText()});
  }
  if (const auto loop = at.find("loop")) rules.loop = loop->boolean();
  if (const auto fitted = at.find("fitted")) rules.fitted = fitted->boolean();
  return rules;
}

/// Refuses wrong values when the file is read, so that the message can state the place.
void checkSemantics(const Scenario& scenario, const JsonCursor& root) {
  const SemanticEdits edits = semanticEditsOf(scenario);
  const auto refuse = [&](Diagnostic why) {
    why.file = root.file();
    throw JsonError{std::move(why)};
  };
  if (const Outcome sound = checkNodes(scenario); !sound) refuse(sound.error());
  const Outcome sound = checkEdits(edits, nodeIdsOf(scenario));
  if (!sound) {
    Diagnostic why = sound.error();
    const std::string at = toString(why.location);
    // Places in the file name a body by its index.
    for (std::size_t i = 0; i < scenario.bodies.size(); ++i) {
      const std::string byId = "/bodies/" + scenario.bodies[i].id + "/attributes/";
      if (at.rfind(byId, 0) == 0) {
        why.location = "/bodies/" + std::to_string(i) + "/attributes/" + at.substr(byId.size());
      }
    }
    for (const auto& [id, attributes] : scenario.sequence.attributes) {
      const std::string byPart = "/bodies/" + id + "/attributes/";
      if (at.rfind(byPart, 0) != 0) continue;
      why.location =
          "/sequence/attributes/" + bodyIdOf(id) + "~1" + pathWithin(id, bodyIdOf(id)) + "/" + at.substr(byPart.size());
    }
    for (std::size_t i = 0; i < scenario.nodes.size(); ++i) {
      const std::string byNode = "/bodies/" + scenario.nodes[i].id + "/attributes/";
      if (at.rfind(byNode, 0) != 0) continue;
      why.location = "/product/" + std::to_string(i) + "/attributes/" + at.substr(byNode.size());
    }
    for (std::size_t i = 0; i < scenario.object.bodies.size(); ++i) {
      const std::string byId = "/bodies/" + scenario.object.bodies[i].id + "/attributes/";
      if (at.rfind(byId, 0) != 0) continue;
      const std::string place = i == 0 ? "/object" : "/object/with/" + std::to_string(i - 1);
      why.location = place + "/attributes/" + at.substr(byId.size());
    }
    refuse(why);
  }
  if (!scenario.rules) return;
  const auto rules = parseRules(*scenario.rules, *attributeTableOf(edits), idsOf(makeLocalPlannerRegistry()));
  if (!rules) refuse(rules.error());
}

template <class Item, class Read>
std::vector<Item> readList(const JsonCursor& root, const char* key, Read read) {
  std::vector<Item> items;
  const auto list = root.find(key);
  for (std::size_t i = 0; list && i < list->sizeUpTo(limits::kMostBodies); ++i) items.push_back(read(list->element(i)));
  return items;
}

}  // namespace

SemanticEdits readSemanticEdits(const JsonCursor& at) {
  at.allowOnly({"attributes", "places", "bodies", "milestones"});
  SemanticEdits edits;
  edits.definitions = readList<AttributeDefinition>(at, "attributes", readDefinition);
  edits.places = readList<PlaceEdit>(at, "places", readPlace);
  edits.milestones = readList<MilestoneEdit>(at, "milestones", readMilestone);
  const auto bodies = at.find("bodies");
  if (!bodies) return edits;
  if (!bodies->json().is_object()) bodies->fail(GLISSADE_TEXT("is not an object"));
  for (const auto& item : bodies->json().items()) edits.bodies[item.key()] = readAttributes(bodies->find(item.key()));
  return edits;
}

void readSemantics(const JsonCursor& root, Scenario& scenario) {
  if (const auto environment = root.find("environment")) scenario.environment = readEnvironmentOptions(*environment);
  scenario.attributeDefinitions = readList<AttributeDefinition>(root, "attributes", readDefinition);
  scenario.places = readList<PlaceEdit>(root, "places", readPlace);
  scenario.milestones = readList<MilestoneEdit>(root, "milestones", readMilestone);
  readForbiddenRegions(root, scenario);
  if (const auto rules = root.find("rules")) scenario.rules = readRules(*rules);
  checkSemantics(scenario, root);
}

Json attributesToJson(const Attributes& attributes) {
  Json json = Json::object();
  for (const auto& [key, value] : attributes) {
    std::visit([&, name = key](const auto& typed) { json[name] = typed; }, value);
  }
  return json;
}

Json toJson(const EnvironmentOptions& options) {
  return {{"cell_size", options.cellSize},
          {"memory", options.memory},
          {"topology_level", options.topologyLevel},
          {"places", options.identifier}};
}

namespace {

Json toJson(const AttributeDefinition& definition) {
  Json json;
  json["name"] = definition.name;
  json["label"] = toString(definition.label);
  json["type"] = kAttributeTypeNames.of(definition.type);
  json["of"] = kAttributeOwnerNames.of(definition.owner);
  if (!definition.unit.empty()) json["unit"] = definition.unit;
  const AttributeDefinition usual;
  if (definition.minimum != usual.minimum) json["minimum"] = definition.minimum;
  if (definition.maximum != usual.maximum) json["maximum"] = definition.maximum;
  if (!definition.choices.empty()) json["choices"] = definition.choices;
  if (!definition.description.empty()) json["description"] = toString(definition.description);
  std::visit([&](const auto& typed) { json["initial"] = typed; }, definition.initial);
  return json;
}

Json toJson(const PlaceEdit& edit) {
  Json json;
  json["at"] = glissade::toJson(edit.at);
  if (!edit.name.empty()) json["name"] = edit.name;
  if (!edit.attributes.empty()) json["attributes"] = attributesToJson(edit.attributes);
  return json;
}

Json toJson(const MilestoneEdit& edit) {
  return {{"at", glissade::toJson(edit.at)}, {"pose", glissade::toJson(edit.q)}};
}

Json toJson(const StrategyRules& rules) {
  Json fine = Json::array();
  for (const FineRule& rule : rules.fine) {
    fine.push_back({{"when", rule.when}, {"geometrical", rule.geometrical}, {"local", rule.local}});
  }
  return {{"node", rules.node}, {"edge", rules.edge}, {"fine", fine}, {"loop", rules.loop}, {"fitted", rules.fitted}};
}

/// The description of a node; created where there is none yet.
NodeDescription& descriptionOf(const std::string& id, Scenario& scenario) {
  for (NodeDescription& node : scenario.nodes) {
    if (node.id == id) return node;
  }
  scenario.nodes.push_back({id});
  return scenario.nodes.back();
}

/// True if the id is that of a part of a body. Attributes of parts are stored in the section about the sequence.
bool isPart(const std::string& id) { return bodyIdOf(id) != id; }

template <class Range>
void addList(const char* key, const Range& range, Json& json) {
  if (range.empty()) return;
  json[key] = Json::array();
  for (const auto& item : range) json[key].push_back(toJson(item));
}

}  // namespace

Json toJson(const SemanticEdits& edits) {
  Json json = Json::object();
  addList("attributes", edits.definitions, json);
  addList("places", edits.places, json);
  for (const auto& [id, attributes] : edits.bodies) json["bodies"][id] = attributesToJson(attributes);
  addList("milestones", edits.milestones, json);
  return json;
}

void addSemantics(const Scenario& scenario, Json& json) {
  if (!(scenario.environment == EnvironmentOptions{})) json["environment"] = toJson(scenario.environment);
  addList("attributes", scenario.attributeDefinitions, json);
  addList("places", scenario.places, json);
  addList("milestones", scenario.milestones, json);
  addForbiddenRegions(scenario.forbiddenRegions, json);
  if (scenario.rules) json["rules"] = toJson(*scenario.rules);
}

SemanticEdits semanticEditsOf(const Scenario& scenario) {
  SemanticEdits edits{scenario.attributeDefinitions, scenario.places, {}, scenario.milestones};
  for (const BodyDescription* body : presentBodiesOf(scenario)) {
    if (!body->attributes.empty()) edits.bodies[body->id] = body->attributes;
  }
  for (const NodeDescription& node : scenario.nodes) {
    if (!node.attributes.empty()) edits.bodies[node.id] = node.attributes;
  }
  for (const auto& [id, attributes] : scenario.sequence.attributes) {
    if (isPart(id)) edits.bodies[id] = attributes;
  }
  return edits;
}

void setSemanticEdits(const SemanticEdits& edits, Scenario& scenario) {
  scenario.attributeDefinitions = edits.definitions;
  scenario.places = edits.places;
  scenario.milestones = edits.milestones;
  const auto attributesOf = [&](const std::string& id) {
    const auto found = edits.bodies.find(id);
    return found == edits.bodies.end() ? Attributes{} : found->second;
  };
  for (BodyDescription& body : scenario.bodies) body.attributes = attributesOf(body.id);
  for (BodyDescription& body : scenario.object.bodies) body.attributes = attributesOf(body.id);
  for (NodeDescription& node : scenario.nodes) node.attributes.clear();
  const Product product = treeOf(scenario);
  auto& ofParts = scenario.sequence.attributes;
  std::erase_if(ofParts, [](const auto& each) { return isPart(each.first); });
  for (const auto& [id, attributes] : edits.bodies) {
    if (attributes.empty()) continue;
    const auto node = product.find(id);
    if (node && product.nodes()[*node].isAssembly) {
      descriptionOf(id, scenario).attributes = attributes;
    } else if (isPart(id)) {
      ofParts[id] = attributes;
    }
  }
  std::erase_if(scenario.nodes, [](const NodeDescription& node) { return node == NodeDescription{node.id}; });
}

}  // namespace glissade
