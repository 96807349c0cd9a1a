#include <glissade/layers.h>

#include <algorithm>
#include <utility>

#include "engine/api/values.h"
#include "engine/places/edit_binding.h"
#include "engine/places/forbidden_places.h"
#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/planning/fine/coarse_preview.h"
#include "engine/planning/planner.h"

namespace glissade::api {

struct Layers::Impl {
  Problem::Impl task;  ///< has knowledge, edits and rules

  const glissade::Problem& problem() const { return task.problem; }
  const SceneKnowledge& knowledge() const { return *problem().scene.knowledge; }
  const TopologicalMap& map() const { return knowledge().environment->map; }
  SemanticEdits edits() const { return problem().scene.edits ? *problem().scene.edits : SemanticEdits(); }
  SemanticModel semantics() const { return semanticsOf(problem(), knowledge(), problem().scene.edits); }
};

namespace {

constexpr const char* kBuilding = "building the layers";

Attributes attributesIn(const AttributeTable& table, AttributeOwner owner,
                        const std::function<ProvenValue(const std::string&)>& valueOf) {
  Attributes all;
  for (const glissade::AttributeDefinition& definition : table.definitions()) {
    if (definition.owner == owner) all[definition.name] = valueOf(definition.name).value;
  }
  return all;
}

Place publicPlace(const Layers::Impl& layers, const SemanticModel& semantics, std::size_t number) {
  const glissade::Place& place = layers.map().places[number];
  Place made;
  made.name = semantics.placeName(number);
  made.box = publicBox(place.box);
  for (const Box3& box : boxesOfCells(layers.map().grid, place.cells)) made.boxes.push_back(publicBox(box));
  made.anchor = place.anchor;
  made.narrowness = place.narrowness;
  made.complexity = place.complexity;
  made.passage = place.passage;
  made.volume = place.volume;
  made.attributes = attributesIn(semantics.table(), AttributeOwner::Place,
                                 [&](const std::string& name) { return semantics.ofPlace(number, name); });
  return made;
}

/// The number of an index that is -1 for none.
std::optional<std::size_t> numberOf(int index) {
  return index < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(index));
}

TopologicalGraph publicGraph(const glissade::TopologicalGraph& graph, const TopologicalMap& map) {
  TopologicalGraph made;
  for (const auto& node : graph.nodes) {
    const auto border = numberOf(node.border);
    const char* const end = made.nodes.empty() ? "S" : "G";
    made.nodes.push_back({border ? map.borders[*border].name : end, border, node.p_W, node.cost});
  }
  for (const auto& edge : graph.edges) {
    made.edges.push_back({static_cast<std::size_t>(edge.from), static_cast<std::size_t>(edge.to),
                          static_cast<std::size_t>(edge.place), edge.distance, edge.cost});
  }
  return made;
}

Rules publicRules(const StrategyRules& rules) {
  std::vector<FineRule> fine;
  for (const glissade::FineRule& rule : rules.fine) fine.push_back({rule.when, rule.geometrical, rule.local});
  return {rules.node, rules.edge, std::move(fine), rules.loop, rules.fitted};
}

StrategyRules engineRules(const Rules& rules) {
  std::vector<glissade::FineRule> fine;
  for (const FineRule& rule : rules.fine) fine.push_back({rule.when, rule.geometrical, rule.local});
  return {rules.node, rules.edge, std::move(fine), rules.loop, rules.fitted};
}

CoarseStep publicStep(const TopologicalStep& step) {
  return {static_cast<std::size_t>(step.place),
          numberOf(step.border),
          step.placeName,
          step.borderName,
          publicPose(step.to),
          step.border < 0 || step.milestone,
          step.planner,
          step.geometrical,
          toString(step.why)};
}

CoarsePlan publicPlan(const glissade::CoarsePlan& plan, const std::string& strategy, const TopologicalMap& map) {
  CoarsePlan made;
  made.strategy = strategy;
  made.rules = publicRules(plan.basis.rules);
  made.graph = publicGraph(*plan.graph, map);
  made.nodes.assign(plan.nodes.begin(), plan.nodes.end());
  made.cost = plan.cost;
  for (const TopologicalStep& step : plan.steps) made.steps.push_back(publicStep(step));
  made.closed = plan.forbidden;
  made.closed.insert(made.closed.end(), plan.infiniteCost.begin(), plan.infiniteCost.end());
  return made;
}

AttributeType typeOf(const AttributeDefinition& definition) {
  if (std::holds_alternative<bool>(definition.initial)) return AttributeType::Bool;
  if (std::holds_alternative<double>(definition.initial)) return AttributeType::Number;
  return definition.choices.empty() ? AttributeType::Text : AttributeType::Choice;
}

glissade::AttributeDefinition engineDefinition(const AttributeDefinition& definition) {
  glissade::AttributeDefinition made;
  made.name = definition.name;
  made.label = Message(definition.name);
  made.type = typeOf(definition);
  made.minimum = definition.minimum;
  made.maximum = definition.maximum;
  made.choices = definition.choices;
  made.initial = definition.initial;
  return made;
}

/// The error of a value that the engine refuses, at this argument.
std::optional<Diagnostic> faultOfValue(const AttributeTable& table, AttributeOwner owner, const std::string& name,
                                       const AttributeValue& value, const std::string& argument) {
  const glissade::AttributeDefinition* definition = table.find(owner, name);
  if (definition == nullptr) return wrongArgument("name", "there is no attribute '" + name + "'");
  const glissade::Outcome sound = checkValue(*definition, value);
  if (sound) return std::nullopt;
  Diagnostic why = publicDiagnostic(sound.error());
  why.place = argument;
  return why;
}

/// The edit of a place, which is added where there is none.
PlaceEdit& editOf(std::size_t place, const TopologicalMap& map, SemanticEdits& edits) {
  for (PlaceEdit& edit : edits.places) {
    if (boundPlace(map, edit.at) == static_cast<int>(place)) return edit;
  }
  edits.places.push_back({map.places[place].anchor, "", {}});
  return edits.places.back();
}

Layers withEdits(const Layers::Impl& layers, SemanticEdits edits) {
  Layers::Impl changed = layers;
  changed.task.problem.scene.edits = std::make_shared<const SemanticEdits>(std::move(edits));
  return valueOf<Layers>(std::move(changed));
}

/// The layers with their knowledge built for the edits.
Result<Layers> built(Problem::Impl task, const StopToken& stop, const SceneKnowledgePtr& before) {
  auto knowledge = buildSceneKnowledge(task.problem, task.parameters[ParameterId::RequiredClearance], stop, before);
  if (!knowledge) return publicDiagnostic(knowledge.error());
  task.problem.scene.knowledge = std::move(*knowledge);
  return valueOf<Layers>({std::move(task)});
}

EnvironmentOptions optionsWith(EnvironmentOptions given, const LayerOptions& options) {
  if (options.cellSize) given.cellSize = *options.cellSize;
  if (options.memory) given.memory = *options.memory;
  if (options.topologyLevel) given.topologyLevel = *options.topologyLevel;
  if (options.identifier) given.identifier = *options.identifier;
  return given;
}

bool hasBody(const glissade::Problem& problem, const std::string& id) {
  const std::vector<RigidBody>& bodies = problem.world->obstacles();
  return id == problem.scene.objectId.text() ||
         std::any_of(bodies.begin(), bodies.end(), [&](const RigidBody& body) { return body.id.text() == id; });
}

Diagnostic unknownStrategy(const std::string& strategy) {
  return wrongArgument("strategy", "'" + strategy + "' does not plan coarsely");
}

}  // namespace

Result<Layers> Layers::make(const Problem& problem, const LayerOptions& options) {
  return attempt<Layers>(kBuilding, [&] {
    Problem::Impl task = problem.impl();
    EnvironmentOptions& environment = task.problem.scene.environment;
    environment = optionsWith(environment, options);
    return built(std::move(task), options.stop, nullptr);
  });
}

OctreeCells Layers::cells() const {
  const Octree& octree = *impl().knowledge().environment->octree;
  OctreeCells all;
  octree.forEachLeaf([&](const Octree::Leaf& leaf) {
    const Box3 box = octree.frame().box(leaf.cell);
    all.centres.emplace_back(box.center());
    all.sizes.push_back(octree.frame().cellSize(leaf.cell.level));
    all.kinds.push_back(static_cast<CellKind>(leaf.kind));
  });
  return all;
}

std::vector<Place> Layers::places() const {
  const SemanticModel semantics = impl().semantics();
  std::vector<Place> all;
  for (std::size_t i = 0; i < semantics.placeCount(); ++i) all.push_back(publicPlace(impl(), semantics, i));
  return all;
}

std::vector<Border> Layers::borders() const {
  std::vector<Border> all;
  for (const glissade::Border& border : impl().map().borders) {
    all.push_back({border.name,
                   {static_cast<std::size_t>(border.placeA), static_cast<std::size_t>(border.placeB)},
                   border.centre,
                   border.normal,
                   border.opening});
  }
  return all;
}

std::string Layers::objectId() const { return impl().problem().scene.objectId.text(); }

Result<Attributes> Layers::ofBody(const std::string& id) const {
  if (!hasBody(impl().problem(), id)) return wrongArgument("id", "there is no body '" + id + "'");
  const SemanticModel semantics = impl().semantics();
  return attributesIn(semantics.table(), AttributeOwner::Body,
                      [&](const std::string& name) { return semantics.ofBody(BodyId(id), name); });
}

Result<Layers> Layers::withPlaceValue(std::size_t place, const std::string& name, const AttributeValue& value) const {
  if (place >= impl().map().places.size()) return wrongArgument("place", "there is no place of this number");
  if (const auto fault = faultOfValue(impl().semantics().table(), AttributeOwner::Place, name, value, "value")) {
    return *fault;
  }
  SemanticEdits edits = impl().edits();
  editOf(place, impl().map(), edits).attributes[name] = value;
  return withEdits(impl(), std::move(edits));
}

Result<Layers> Layers::withBodyValue(const std::string& id, const std::string& name, const AttributeValue& value,
                                     const StopToken& stop) const {
  if (!hasBody(impl().problem(), id)) return wrongArgument("id", "there is no body '" + id + "'");
  if (const auto fault = faultOfValue(impl().semantics().table(), AttributeOwner::Body, name, value, "value")) {
    return *fault;
  }
  SemanticEdits edits = impl().edits();
  edits.bodies[id][name] = value;
  const Layers edited = withEdits(impl(), std::move(edits));
  if (name != "mobility") return edited;
  return attempt<Layers>(kBuilding,
                         [&] { return built(edited.impl().task, stop, edited.impl().problem().scene.knowledge); });
}

Result<Layers> Layers::withAttribute(const AttributeDefinition& definition, const PlaceFunction& compute) const {
  return attempt<Layers>("adding an attribute", [&]() -> Result<Layers> {
    SemanticEdits edits = impl().edits();
    edits.definitions.push_back(engineDefinition(definition));
    const auto table = attributeTableOf(edits);
    if (!table) return publicDiagnostic(table.error());
    const std::vector<Place> all = compute ? places() : std::vector<Place>();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const AttributeValue value = compute(all[i]);
      const std::string argument = "the value of place " + all[i].name;
      if (auto fault = faultOfValue(*table, AttributeOwner::Place, definition.name, value, argument)) return *fault;
      editOf(i, impl().map(), edits).attributes[definition.name] = value;
    }
    return withEdits(impl(), std::move(edits));
  });
}

Result<Layers> Layers::withRules(const Rules& rules) const {
  return attempt<Layers>("reading rules", [&]() -> Result<Layers> {
    auto own = std::make_shared<const StrategyRules>(engineRules(rules));
    const auto parsed = parseRules(*own, impl().semantics().table(), idsOf(makeLocalPlannerRegistry()));
    if (!parsed) return publicDiagnostic(parsed.error());
    Impl changed = impl();
    changed.task.problem.scene.rules = std::move(own);
    return valueOf<Layers>(std::move(changed));
  });
}

Result<Rules> Layers::rules(const std::string& strategy) const {
  if (!isMultiLayer(strategy)) return unknownStrategy(strategy);
  return publicRules(rulesOf(impl().problem(), strategy));
}

Result<CoarsePlan> Layers::coarsePlan(const std::string& strategy) const {
  if (!isMultiLayer(strategy)) return unknownStrategy(strategy);
  return attempt<CoarsePlan>("planning coarsely", [&]() -> Result<CoarsePlan> {
    const SceneDescription& scene = impl().problem().scene;
    const auto plan = previewPlan({impl().problem(), strategy, scene.knowledge, scene.edits, nullptr});
    if (!plan) return publicDiagnostic(plan.error());
    if (!*plan) return Diagnostic{ErrorKind::NoPath, "", "", "the bounds have no configuration outside", ""};
    return publicPlan(**plan, strategy, impl().map());
  });
}

Problem Layers::problem() const { return valueOf<Problem>(impl().task); }

}  // namespace glissade::api
