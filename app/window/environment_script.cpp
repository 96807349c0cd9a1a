#include "app/window/environment_script.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTreeWidget>

#include <algorithm>

#include "app/window/environment_controller.h"
#include "engine/base/number_text.h"
#include "engine/environment/place_identifier.h"
#include "engine/scenario/scenario_bodies.h"

namespace glissade {
namespace {

/// "yes", "no", a number, or any text.
AttributeValue valueOf(const std::string& text) {
  if (text == "yes" || text == "no") return text == "yes";
  if (const auto number = toNumber(text)) return *number;
  return text;
}

/// By the mouse: a row that is highlighted already can be chosen again.
Outcome clickStep(const EnvironmentController& environment, const std::string& name) {
  auto* steps = environment.planPanel()->findChild<QTreeWidget*>(QStringLiteral("steps"));
  const auto number = toNumber(name);
  QTreeWidgetItem* item = number ? steps->topLevelItem(static_cast<int>(*number) - 1) : nullptr;
  if (item == nullptr) return wrongCommand("there is no step '" + name + "'");
  steps->scrollToItem(item);
  for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type, steps->visualItemRect(item).center(), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(steps->viewport(), &event);
  }
  return Done{};
}

bool hasBody(const LoadedScenario& scenario, const std::string& id) {
  const auto& obstacles = scenario.obstacles;
  return isInObject(scenario, id) ||
         std::any_of(obstacles.begin(), obstacles.end(), [&id](const RigidBody& body) { return body.id == id; });
}

Outcome select(WorkbenchDocument& workbench, const EnvironmentController& environment, const std::string& kind,
               const std::string& name) {
  SemanticDocument& document = workbench.semantics();
  SemanticSelection selection;
  if (kind == "body" && workbench.scenario() && hasBody(*workbench.scenario(), name)) {
    selection.bodies.insert(QString::fromStdString(name));
  } else if (kind == "bodies" && workbench.scenario()) {  // "nut+bolt"
    for (const QString& id : QString::fromStdString(name).split(QLatin1Char('+'))) {
      if (hasBody(*workbench.scenario(), id.toStdString())) selection.bodies.insert(id);
    }
  } else if (kind == "step") {
    return clickStep(environment, name);
  } else if (kind == "place" && document.semantics() != nullptr) {
    for (std::size_t place = 0; place < document.semantics()->placeCount(); ++place) {
      if (document.semantics()->placeName(place) == name) selection.places.insert(static_cast<int>(place));
    }
  }
  if (selection == SemanticSelection{}) {
    return wrongCommand("there is no " + kind + " '" + name + "'",
                        kind == "place" ? "Find the places first." : "Give its id.");
  }
  document.select(selection);
  return Done{};
}

Outcome setAttribute(SemanticDocument& document, const std::string& name, const std::string& value) {
  if (document.selection() == SemanticSelection{})
    return wrongCommand("nothing is selected", "Select a place or a body first.");
  document.endGesture();
  return document.setAttribute(document.selection().shown(), name,
                               value == "-" ? std::nullopt : std::optional<AttributeValue>(valueOf(value)));
}

/// Key by key, and not committed.
Outcome type(const EnvironmentController& environment, const std::string& name, const std::string& text) {
  const QString id = QString::fromStdString("attribute-" + name);
  auto* editor = environment.semanticsPanel()->findChild<QWidget*>(id);
  if (editor == nullptr) return wrongCommand("there is no editor of '" + name + "'", "Select a place or a body first.");
  editor->setFocus(Qt::TabFocusReason);
  for (const QChar key : QString::fromStdString(text)) {
    QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, key);
    QApplication::sendEvent(editor, &event);
  }
  return Done{};
}

Outcome define(SemanticDocument& document, const std::string& name, const std::string& type, const std::string& owner) {
  AttributeDefinition definition;
  const auto known = attributeTypeByName(type);
  if (!known) return wrongCommand("there is no type '" + type + "'");
  definition.name = definition.label = name;
  definition.type = *known;
  definition.owner = owner == "body" ? AttributeOwner::Body : AttributeOwner::Place;
  definition.initial = initialValue(definition);
  return document.addDefinition(definition);
}

Outcome expectAttribute(const SemanticDocument& document, const std::string& name, const std::string& value) {
  const auto check = [&](const ProvenValue& found) -> Outcome {
    if (toText(found.value) == value) return Done{};
    return unmetExpectation("'" + name + "' is " + toText(found.value) + ", not " + value);
  };
  const SemanticSelection shown = document.selection().shown();
  const AttributeOwner owner = shown.owner();
  if (document.table().find(owner, name) == nullptr) return wrongCommand("there is no attribute '" + name + "'");
  for (const int place : shown.places) {
    const Outcome met = check(document.semantics()->ofPlace(static_cast<std::size_t>(place), name));
    if (!met) return met;
  }
  for (const QString& body : shown.bodies) {
    const Outcome met = check(document.bodyValue(body, name));
    if (!met) return met;
  }
  return Done{};
}

Outcome expectWay(const EnvironmentController& environment, const std::string& names) {
  std::string way;
  if (const CoarsePlanPtr& plan = environment.shownPlan()) {
    for (const TopologicalStep& step : plan->steps) way += (way.empty() ? "" : ",") + step.placeName;
  }
  if (way == names) return Done{};
  return unmetExpectation("the coarse path leads through " + (way.empty() ? "nothing" : way) + ", not " + names);
}

Outcome expectStep(const EnvironmentController& environment, const std::string& name) {
  const auto step = environment.planPanel()->currentStep();
  const std::string found = step ? environment.shownPlan()->steps[*step].placeName : "-";
  return found == name ? Outcome(Done{})
                       : unmetExpectation("the step that is highlighted is " + found + ", not " + name);
}

Outcome expectPlan(const EnvironmentController& environment, const std::string& what) {
  const CoarsePlanPtr& plan = environment.shownPlan();
  const std::string found = !plan ? "none" : plan->attempt == 0 ? "preview" : "tried";
  return found == what ? Outcome(Done{})
                       : unmetExpectation("the coarse plan that is shown is " + found + ", not " + what);
}

Outcome identify(EnvironmentController& environment, const std::string& identifier) {
  const PlaceIdentifierRegistry registry = makePlaceIdentifierRegistry();
  if (registry.find(identifier) == nullptr) return wrongCommand("places cannot be found by '" + identifier + "'");
  environment.identifyPlaces(identifier);
  return Done{};
}

}  // namespace

void addEnvironmentCommands(const Workbench& bench, EnvironmentController& environment) {
  using Words = ScriptCommands::Words;
  ScriptCommands& scripts = bench.scripts;
  SemanticDocument& document = bench.document.semantics();
  scripts.add("select", 2, [&bench, &environment](const Words& words) {
    return select(bench.document, environment, words[0], words[1]);
  });
  scripts.add("attribute", 2, [&document](const Words& words) { return setAttribute(document, words[0], words[1]); });
  scripts.add("type", 2, [&environment](const Words& words) { return type(environment, words[0], words[1]); });
  scripts.add("define", 3, [&document](const Words& words) { return define(document, words[0], words[1], words[2]); });
  scripts.add("expect-attribute", 2,
              [&document](const Words& words) { return expectAttribute(document, words[0], words[1]); });
  scripts.add("expect-way", 1, [&environment](const Words& words) { return expectWay(environment, words[0]); });
  scripts.add("expect-step", 1, [&environment](const Words& words) { return expectStep(environment, words[0]); });
  scripts.add("expect-plan", 1, [&environment](const Words& words) { return expectPlan(environment, words[0]); });
  scripts.add("identify", 1, [&environment](const Words& words) { return identify(environment, words[0]); });
}

}  // namespace glissade
