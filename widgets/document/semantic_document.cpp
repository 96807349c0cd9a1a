#include "widgets/document/semantic_document.h"

#include <algorithm>

#include "engine/files/scenario_bodies.h"
#include "engine/places/edit_binding.h"
#include "engine/places/held_edits.h"
#include "engine/planning/planner.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/document/value_command.h"

namespace glissade {

SemanticDocument::SemanticDocument(QUndoStack& undo, QObject* parent) : QObject(parent), undo_(undo) {
  connect(&undo, &QUndoStack::indexChanged, this, [this] {
    if (undo_.canRedo()) endGesture();  // something was undone
  });
}
SemanticDocument::~SemanticDocument() = default;

void SemanticDocument::open(const LoadedScenario& scenario) {
  takeScenario(scenario);
  knowledge_.reset();
  semantics_.reset();
  selection_ = {};
  apply(semanticEditsOf(scenario.scenario));
  emit selectionChanged();
}

void SemanticDocument::takeScenario(const LoadedScenario& scenario) {
  bodies_ = rigidBodiesOf(scenario);
  obstacles_ = scenario.obstacles.size();
  product_ = scenario.product;
  rules_ = scenario.scenario.rules;
}

void SemanticDocument::rearrange(const LoadedScenario& scenario) {
  takeScenario(scenario);
  SemanticSelection selection;
  selection.places = selection_.places;
  for (const QString& id : selection_.bodies) {
    const std::string known = id.toStdString();
    const bool isThere =
        product_.find(known) ||
        std::any_of(bodies_.begin(), bodies_.end(), [&](const RigidBody& body) { return body.id.text() == known; });
    if (isThere) selection.bodies.insert(id);
  }
  apply(semanticEditsOf(scenario.scenario));
  select(selection);
}

/// Sets the model. Selected places that it does not have are no longer selected.
void SemanticDocument::setKnowledge(const SceneKnowledgePtr& knowledge) {
  knowledge_ = knowledge;
  const SemanticSelection before = selection_;
  const int places = knowledge ? static_cast<int>(knowledge->environment->map.places.size()) : 0;
  for (const int place : before.places) {
    if (knowledge && place >= places) selection_.places.remove(place);
  }
  apply(edits_);
  if (!(selection_ == before)) emit selectionChanged();
}

void SemanticDocument::apply(const SemanticEdits& edits) {
  edits_ = edits;
  held_ = glissade::heldEdits(edits, product_);
  if (auto table = attributeTableOf(edits_)) table_ = std::move(*table);
  semantics_.reset();
  warnings_.clear();
  if (knowledge_) {
    warnings_ = editWarnings(knowledge_->environment->map, edits_);
    const auto object = bodies_.begin() + static_cast<std::ptrdiff_t>(obstacles_);
    const std::vector<RigidBody> obstacles(bodies_.begin(), object);
    semantics_.emplace(knowledge_->environment, obstacles, object->id, held_, knowledge_->compatibility());
  }
  emit changed();
}

void SemanticDocument::push(const QString& text, const SemanticEdits& after, const QString& mergeKey) {
  if (after == edits_) return;
  const auto take = [this](const SemanticEdits& edits) { apply(edits); };
  undo_.push(new ValueCommand<SemanticEdits>(text, edits_, after, take, mergeKey));
}

/// Null if no edit sets the attribute.
const AttributeValue* SemanticDocument::said(const std::string& id, const std::string& attribute) const {
  const auto edited = edits_.bodies.find(id);
  if (edited == edits_.bodies.end()) return nullptr;
  const auto value = edited->second.find(attribute);
  return value == edited->second.end() ? nullptr : &value->second;
}

ProvenValue SemanticDocument::bodyValue(const QString& bodyId, const std::string& attribute) const {
  const std::string id = bodyId.toStdString();
  if (const AttributeValue* own = said(id, attribute)) return {*own, Provenance::Edited};
  for (auto node = product_.find(id); node; node = product_.nodes()[*node].parent) {
    const AttributeValue* value = said(product_.nodes()[*node].id, attribute);
    if (value != nullptr) return {*value, Provenance::Inherited};
  }
  const auto body = std::find_if(bodies_.begin(), bodies_.end(), [&](const RigidBody& b) { return b.id.text() == id; });
  if (attribute == "mobility" && body != bodies_.end()) {
    return {std::string(kMobilityNames.of(body->mobility)), Provenance::Computed};
  }
  return {table_.find(AttributeOwner::Body, attribute)->initial, Provenance::Initial};
}

/// The edit of a place, made if there is none yet. Several edits become one, in which the later values count; an edit
/// that lies only near the place moves to its anchor.
PlaceEdit& SemanticDocument::editOf(SemanticEdits& edits, int place) const {
  const TopologicalMap& map = knowledge_->environment->map;
  const auto isBound = [&](const PlaceEdit& edit) { return boundPlace(map, edit.at) == place; };
  const Vector3& anchor = map.places[static_cast<std::size_t>(place)].anchor;
  const auto first = std::find_if(edits.places.begin(), edits.places.end(), isBound);
  if (first == edits.places.end()) {
    edits.places.push_back({anchor, "", {}});
    return edits.places.back();
  }
  if (map.placeAt(first->at) != place) first->at = anchor;
  for (auto other = first + 1; other != edits.places.end(); ++other) {
    if (!isBound(*other)) continue;
    if (!other->name.empty()) first->name = other->name;
    for (const auto& [name, value] : other->attributes) first->attributes[name] = value;
  }
  edits.places.erase(std::remove_if(first + 1, edits.places.end(), isBound), edits.places.end());
  return *first;
}

Outcome SemanticDocument::setAttribute(const SemanticSelection& targets, const std::string& attribute,
                                       const std::optional<AttributeValue>& value) {
  SemanticEdits after = edits_;
  const auto set = [&](AttributeOwner owner, Attributes& attributes) -> Outcome {
    const AttributeDefinition* definition = table_.find(owner, attribute);
    if (definition == nullptr) {
      return Diagnostic{ErrorKind::Usage, "", attribute, GLISSADE_TEXT("there is no such attribute"),
                        GLISSADE_TEXT("Add it first.")};
    }
    if (!value) {
      attributes.erase(attribute);
      return Done{};
    }
    const Outcome sound = checkValue(*definition, *value);
    if (sound) attributes[attribute] = *value;
    return sound;
  };
  QString key = QStringLiteral("%1 %2").arg(gesture_).arg(QString::fromStdString(attribute));
  QList<int> places = targets.places.values();
  std::sort(places.begin(), places.end());
  for (const int place : places) {
    if (!knowledge_) break;
    const Outcome outcome = set(AttributeOwner::Place, editOf(after, place).attributes);
    if (!outcome) return outcome;
    key += QStringLiteral(" p%1").arg(place);
  }
  QStringList bodies = targets.bodies.values();
  bodies.sort();
  for (const QString& body : bodies) {
    const Outcome outcome = set(AttributeOwner::Body, after.bodies[body.toStdString()]);
    if (!outcome) return outcome;
    key += QStringLiteral(" b") + body;
  }
  // Edits that set nothing are removed.
  after.places.erase(std::remove_if(after.places.begin(), after.places.end(),
                                    [](const PlaceEdit& edit) { return edit.name.empty() && edit.attributes.empty(); }),
                     after.places.end());
  for (auto body = after.bodies.begin(); body != after.bodies.end();) {
    body = body->second.empty() ? after.bodies.erase(body) : std::next(body);
  }
  const QString name = QString::fromStdString(attribute);
  push(value ? tr("Set %1").arg(name) : tr("Reset %1").arg(name), after, value ? key : QString());
  return Done{};
}

Outcome SemanticDocument::renamePlace(int place, const QString& name) {
  const std::string newName = name.trimmed().toStdString();
  for (std::size_t other = 0; other < semantics_->placeCount(); ++other) {
    if (static_cast<int>(other) != place && semantics_->placeName(other) == newName) {
      return Diagnostic{ErrorKind::Usage, "", newName, GLISSADE_TEXT("another place has this name"),
                        GLISSADE_TEXT("Choose another.")};
    }
  }
  SemanticEdits after = edits_;
  editOf(after, place).name = newName;
  push(tr("Rename place"), after);
  return Done{};
}

Outcome SemanticDocument::addDefinition(const AttributeDefinition& definition) {
  AttributeTable table = table_;
  const Outcome added = table.add(definition);
  if (!added) return added;
  SemanticEdits after = edits_;
  after.definitions.push_back(definition);
  push(tr("Add attribute %1").arg(QString::fromStdString(definition.name)), after);
  return Done{};
}

namespace {

/// Calls change(attributes) for the attributes of every place or every body.
template <class Change>
void forEachOwner(SemanticEdits& edits, AttributeOwner owner, Change&& change) {
  if (owner == AttributeOwner::Place) {
    for (PlaceEdit& place : edits.places) change(place.attributes);
  } else {
    for (auto& [id, attributes] : edits.bodies) change(attributes);
  }
}

}  // namespace

/// Refuses definitions that clash, or lack an attribute that a rule uses.
Outcome SemanticDocument::checkDefinitions(const SemanticEdits& edits, const std::string& attribute) const {
  const auto table = attributeTableOf(edits);
  if (!table) return table.error();
  if (!rules_) return Done{};
  const auto parsed = parseRules(*rules_, *table, idsOf(makeLocalPlannerRegistry()));
  if (parsed) return Done{};
  const std::string rule = toString(parsed.error().location);
  return Diagnostic{ErrorKind::Usage,
                    "",
                    rule,
                    {GLISSADE_TEXT("the scenario's rule %1 uses the attribute '%2'"), {rule, attribute}},
                    GLISSADE_TEXT("Change the rule first.")};
}

Outcome SemanticDocument::renameDefinition(AttributeOwner owner, const std::string& from, const std::string& to) {
  SemanticEdits after = edits_;
  for (AttributeDefinition& definition : after.definitions) {
    if (definition.owner != owner || definition.name != from) continue;
    definition.name = to;
    definition.label = Message(to);
  }
  const Outcome sound = checkDefinitions(after, from);
  if (!sound) return sound;
  forEachOwner(after, owner, [&](Attributes& attributes) {
    const auto old = attributes.extract(from);
    if (!old.empty()) attributes[to] = old.mapped();
  });
  push(tr("Rename attribute"), after);
  return Done{};
}

Outcome SemanticDocument::removeDefinition(AttributeOwner owner, const std::string& name) {
  SemanticEdits after = edits_;
  after.definitions.erase(std::remove_if(after.definitions.begin(), after.definitions.end(),
                                         [&](const AttributeDefinition& definition) {
                                           return definition.owner == owner && definition.name == name;
                                         }),
                          after.definitions.end());
  const Outcome sound = checkDefinitions(after, name);
  if (!sound) return sound;
  forEachOwner(after, owner, [&](Attributes& attributes) { attributes.erase(name); });
  push(tr("Remove attribute %1").arg(QString::fromStdString(name)), after);
  return Done{};
}

bool SemanticDocument::hasStrays() const {
  return knowledge_ && !(withoutStrays(knowledge_->environment->map, edits_) == edits_);
}

void SemanticDocument::removeStrays() {
  if (knowledge_) push(tr("Remove edits without effect"), withoutStrays(knowledge_->environment->map, edits_));
}

void SemanticDocument::setMilestone(int border, const std::optional<Pose>& q) {
  const TopologicalMap& map = knowledge_->environment->map;
  const Border& where = map.borders[static_cast<std::size_t>(border)];
  SemanticEdits after = edits_;
  after.milestones.erase(std::remove_if(after.milestones.begin(), after.milestones.end(),
                                        [&](const MilestoneEdit& edit) {
                                          const std::vector<int> borders = boundBorders(map, edit.at);
                                          return std::find(borders.begin(), borders.end(), border) != borders.end();
                                        }),
                         after.milestones.end());
  if (q) after.milestones.push_back({map.grid.centre(where.cells[where.cells.size() / 2]), *q});
  push(q ? tr("Move milestone") : tr("Reset milestone"), after);
}

QSet<QString> SemanticDocument::selectedBodies() const {
  QSet<QString> bodies;
  for (const QString& id : selection_.bodies) {
    const auto node = product_.find(id.toStdString());
    if (!node || !product_.nodes()[*node].isAssembly) {
      bodies.insert(id);
      continue;
    }
    for (const BodyId& body : product_.bodiesBelow(*node)) bodies.insert(toQString(body));
  }
  return bodies;
}

void SemanticDocument::select(const SemanticSelection& selection) {
  if (selection == selection_) return;
  selection_ = selection;
  emit selectionChanged();
}

}  // namespace glissade
