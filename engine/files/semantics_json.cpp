#include "engine/files/semantics_json.h"

#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_product.h"
#include "engine/geometry/pose_json.h"
#include "engine/planning/planner.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

/// More cells than this are in no topological layer.
constexpr std::size_t kMostBoxes = 4'000'000;
/// Most choices of an attribute, because they are searched sequentially.
constexpr std::size_t kMostChoices = 1000;
/// Most rules of a strategy, because they are tried sequentially.
constexpr std::size_t kMostRules = 1000;

constexpr FunctionFormat kBox{[](const JsonCursor& at) {
                                Box3 box;
                                for (int axis = 0; axis < 3 && at.size() == 6; ++axis) {
                                  const auto i = static_cast<std::size_t>(axis);
                                  box.min()[axis] = at.element(i).coordinate();
                                  box.max()[axis] = at.element(i + 3).coordinate();
                                }
                                if (box.isEmpty()) {
                                  at.fail(GLISSADE_TEXT("is not a box"),
                                          GLISSADE_TEXT("Give six coordinates: the least x, y and z, then the "
                                                        "largest."));
                                }
                                return box;
                              },
                              [](const Box3& box) {
                                const Vector3& least = box.min();
                                const Vector3& most = box.max();
                                return Json{least.x(), least.y(), least.z(), most.x(), most.y(), most.z()};
                              },
                              R"({"description": "Least x, y and z, then the largest.", "type": "array", "minItems": 6,
                                  "maxItems": 6, "items": {"type": "number"}})"};

constexpr FunctionFormat kAttributeValue{
    [](const JsonCursor& at) -> AttributeValue {
      if (at.json().is_boolean()) return at.boolean();
      if (at.isString()) return at.text();
      return at.number();
    },
    [](const AttributeValue& value) { return std::visit([](const auto& typed) { return Json(typed); }, value); },
    R"({"type": ["boolean", "number", "string"]})"};

constexpr GetterFormat<std::string> kAttributeName{&JsonCursor::nonEmptyText,
                                                   R"({"type": "string", "pattern": "^[a-z_][a-z0-9_]*$"})"};

constexpr FunctionFormat kCellSize{[](const JsonCursor& at) {
                                     const double size = at.coordinate();
                                     if (size < 0.0) {
                                       at.fail(GLISSADE_TEXT("is below zero"),
                                               GLISSADE_TEXT("Give metres, or 0 for as fine as the memory allows."));
                                     }
                                     return size;
                                   },
                                   kAsItIs, R"({"type": "number", "minimum": 0})"};

constexpr FunctionFormat kTopologyLevel{[](const JsonCursor& at) {
                                          const std::uint64_t value = at.wholeNumber();
                                          if (value < 2 || value > 8)
                                            at.fail(GLISSADE_TEXT("is out of range"), GLISSADE_TEXT("Give 2 to 8."));
                                          return static_cast<int>(value);
                                        },
                                        kAsItIs, R"({"type": "integer", "minimum": 2, "maximum": 8})"};

constexpr FunctionFormat kIdentifier{[](const JsonCursor& at) {
                                       std::string id = at.text();
                                       if (makePlaceIdentifierRegistry().find(id) == nullptr) {
                                         at.fail(GLISSADE_TEXT("names no way to find places"),
                                                 GLISSADE_TEXT("Give region-growing or watershed."));
                                       }
                                       return id;
                                     },
                                     kAsItIs, R"({"enum": ["region-growing", "watershed"]})"};

}  // namespace

Attributes AttributesFormat::read(const JsonCursor& at) const { return mapOf(kAttributeValue).read(at); }
Json AttributesFormat::write(const Attributes& attributes) const { return mapOf(kAttributeValue).write(attributes); }
Json AttributesFormat::schema(SchemaDefinitions& definitions) const {
  return definitions.reference("attributes", mapOf(kAttributeValue).schema(definitions));
}

template <class Archive>
void describe(Archive& options, Type<EnvironmentOptions> /*type*/) {
  options.type("environment",
               "How the environment is modelled: the finest cells of the octree, and how places are found.");
  options.optional("cell_size", &EnvironmentOptions::cellSize, kCellSize, "Metres; 0: by memory.", Always());
  options.optional("memory", &EnvironmentOptions::memory, kPositive, "MiB for the octree where cell_size is 0.",
                   Always());
  options.optional("topology_level", &EnvironmentOptions::topologyLevel, kTopologyLevel,
                   "Level of the cells of places.", Always());
  options.optional("places", &EnvironmentOptions::identifier, kIdentifier, "", Always());
}

template <class Archive>
void describe(Archive& definition, Type<AttributeDefinition> /*type*/) {
  using Definition = AttributeDefinition;
  definition.type("attribute_definition");
  definition.required("name", &Definition::name, kAttributeName, "The name in rules and files.");
  definition.check([](Definition& read, const JsonCursor& /*at*/) { read.label = Message(read.name); });
  definition.optional("label", &Definition::label, kEnglish, "", Always());
  definition.required("type", &Definition::type, named(kAttributeTypeNames));
  definition.required("of", &Definition::owner, named(kAttributeOwnerNames), "Kind of thing that has the attribute.");
  definition.optional("unit", &Definition::unit, kText);
  definition.optional("minimum", &Definition::minimum, kNumber);
  definition.optional("maximum", &Definition::maximum, kNumber);
  definition.optional("choices", &Definition::choices, listOf(kNonEmptyText, 0, kMostChoices));
  definition.optional("description", &Definition::description, kEnglish);
  definition.check([](Definition& read, const JsonCursor& /*at*/) { read.initial = initialValue(read); });
  definition.optional("initial", &Definition::initial, kAttributeValue, "", Always());
}

template <class Archive>
void describe(Archive& place, Type<PlaceEdit> /*type*/) {
  place.type("place_edit");
  place.required("at", &PlaceEdit::at, kVector, "A point inside the place.");
  place.optional("name", &PlaceEdit::name, kText);
  place.optional("attributes", &PlaceEdit::attributes, AttributesFormat());
}

template <class Archive>
void describe(Archive& milestone, Type<MilestoneEdit> /*type*/) {
  milestone.type("milestone");
  milestone.required("at", &MilestoneEdit::at, kVector, "A point inside the overlap of the border.");
  milestone.required("pose", &MilestoneEdit::q, kObject<Pose>, "The configuration to pass through.");
}

template <class Archive>
void describe(Archive& place, Type<ForbiddenPlace> /*type*/) {
  place.type("forbidden_region");
  place.required("place", &ForbiddenPlace::name, kNonEmptyText);
  place.required("boxes", &ForbiddenPlace::boxes, listOf(kBox, 0, kMostBoxes));
}

template <class Archive>
void describe(Archive& rule, Type<FineRule> /*type*/) {
  rule.type("fine_rule");
  rule.required("when", &FineRule::when, kNonEmptyText);
  rule.optional("geometrical", &FineRule::geometrical, kBoolean, "", Always());
  rule.required("local", &FineRule::local, kNonEmptyText);
}

template <class Archive>
void describe(Archive& rules, Type<StrategyRules> /*type*/) {
  rules.type(
      "rules",
      "Strategy \"own\": costs of borders and places, and which planners cross a place; the last rule of fine is "
      "for all places.");
  rules.required("node", &StrategyRules::node, kNonEmptyText);
  rules.required("edge", &StrategyRules::edge, kNonEmptyText);
  rules.required("fine", &StrategyRules::fine, listOf(kObject<FineRule>, 1, kMostRules));
  rules.optional("loop", &StrategyRules::loop, kBoolean, "", Always());
  rules.optional("fitted", &StrategyRules::fitted, kBoolean, "", Always());
}

template <class Archive>
void describe(Archive& edits, Type<SemanticEdits> /*type*/) {
  edits.type("semantic_edits");
  edits.optional("attributes", &SemanticEdits::definitions, kObjects<AttributeDefinition>);
  edits.optional("places", &SemanticEdits::places, kObjects<PlaceEdit>);
  edits.optional("bodies", &SemanticEdits::bodies, mapOf(AttributesFormat()));
  edits.optional("milestones", &SemanticEdits::milestones, kObjects<MilestoneEdit>);
}

template struct ObjectFormat<EnvironmentOptions>;
template struct ObjectFormat<AttributeDefinition>;
template struct ObjectFormat<PlaceEdit>;
template struct ObjectFormat<MilestoneEdit>;
template struct ObjectFormat<ForbiddenPlace>;
template struct ObjectFormat<StrategyRules>;
template struct ObjectFormat<SemanticEdits>;

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
      const std::string byId = "/bodies/" + scenario.bodies[i].id.text() + "/attributes/";
      if (at.rfind(byId, 0) == 0) {
        why.location = "/bodies/" + std::to_string(i) + "/attributes/" + at.substr(byId.size());
      }
    }
    for (const auto& [id, attributes] : scenario.sequence.attributes) {
      const std::string byPart = "/bodies/" + id + "/attributes/";
      if (at.rfind(byPart, 0) != 0) continue;
      why.location = "/sequence/attributes/" + firstStepOf(id) + "~1" + pathWithin(id, firstStepOf(id)) + "/" +
                     at.substr(byPart.size());
    }
    for (std::size_t i = 0; i < scenario.nodes.size(); ++i) {
      const std::string byNode = "/bodies/" + scenario.nodes[i].id + "/attributes/";
      if (at.rfind(byNode, 0) != 0) continue;
      why.location = "/product/" + std::to_string(i) + "/attributes/" + at.substr(byNode.size());
    }
    for (std::size_t i = 0; i < scenario.object.bodies.size(); ++i) {
      const std::string byId = "/bodies/" + scenario.object.bodies[i].id.text() + "/attributes/";
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

namespace {

/// The description of a node; created where there is none yet.
NodeDescription& descriptionOf(const std::string& id, Scenario& scenario) {
  for (NodeDescription& node : scenario.nodes) {
    if (node.id == id) return node;
  }
  scenario.nodes.push_back({id});
  return scenario.nodes.back();
}

/// True if the id is that of a part of a body. Attributes of parts are stored in the section about the sequence.
bool isPart(const std::string& id) { return firstStepOf(id) != id; }

}  // namespace

SemanticEdits semanticEditsOf(const Scenario& scenario) {
  SemanticEdits edits{scenario.attributeDefinitions, scenario.places, {}, scenario.milestones};
  for (const BodyDescription* body : presentBodiesOf(scenario)) {
    if (!body->attributes.empty()) edits.bodies[body->id.text()] = body->attributes;
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
  for (BodyDescription& body : scenario.bodies) body.attributes = attributesOf(body.id.text());
  for (BodyDescription& body : scenario.object.bodies) body.attributes = attributesOf(body.id.text());
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
