#include "app/window/environment_script.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTreeWidget>

#include "app/window/body_visibility.h"
#include "app/window/environment_controller.h"
#include "engine/base/number_text.h"
#include "engine/environment/place_identifier.h"

namespace glissade {
namespace {

Diagnostic usage(const std::string& reason, const std::string& advice = "") {
  return {ErrorKind::MalformedInput, "", "", reason, advice};
}

Diagnostic unmet(const std::string& reason) { return {ErrorKind::NoPath, "", "", reason, ""}; }

/// "yes", "no", a number, or any text.
AttributeValue valueOf(const std::string& text) {
  if (text == "yes" || text == "no") return text == "yes";
  if (const auto number = toNumber(text)) return *number;
  return text;
}

}  // namespace

std::optional<Outcome> EnvironmentScript::carryOut(const ScriptCommand& command) {
  const auto& words = command.arguments;
  if (command.name == "select") return select(words[0], words[1]);
  if (command.name == "click" || command.name == "drag") return press(words);
  if (command.name == "show-body") return showBody(words[0], words[1]);
  if (command.name == "attribute") return setAttribute(words[0], words[1]);
  if (command.name == "type") return type(words[0], words[1]);
  if (command.name == "define") return define(words[0], words[1], words[2]);
  if (command.name == "expect-attribute") return expectAttribute(words[0], words[1]);
  if (command.name == "expect-way") return expectWay(words[0]);
  if (command.name == "expect-step") return expectStep(words[0]);
  if (command.name == "expect-plan") return expectPlan(words[0]);
  if (command.name == "identify") return identify(words[0]);
  return std::nullopt;
}

Outcome EnvironmentScript::select(const std::string& kind, const std::string& name) {
  SemanticDocument& document = window_.environment().document();
  SemanticSelection selection;
  if (kind == "body") {
    selection.bodies.insert(QString::fromStdString(name));
  } else if (kind == "step") {
    return clickStep(name);
  } else if (kind == "place" && document.semantics() != nullptr) {
    for (std::size_t place = 0; place < document.semantics()->placeCount(); ++place) {
      if (document.semantics()->placeName(place) == name) selection.places.insert(static_cast<int>(place));
    }
  }
  if (selection == SemanticSelection{})
    return usage("there is no " + kind + " '" + name + "'", "Find the places first.");
  document.select(selection);
  return Done{};
}

/// By the mouse: a row that is highlighted already can be chosen again.
Outcome EnvironmentScript::clickStep(const std::string& name) {
  auto* steps = window_.environment().planPanel()->findChild<QTreeWidget*>(QStringLiteral("steps"));
  const auto number = toNumber(name);
  QTreeWidgetItem* item = number ? steps->topLevelItem(static_cast<int>(*number) - 1) : nullptr;
  if (item == nullptr) return usage("there is no step '" + name + "'");
  steps->scrollToItem(item);
  for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type, steps->visualItemRect(item).center(), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(steps->viewport(), &event);
  }
  return Done{};
}

/// A click where there is one pixel, a drag where there are two.
Outcome EnvironmentScript::showBody(const std::string& id, const std::string& visible) {
  if (visible != "yes" && visible != "no") return usage("say yes or no");
  if (window_.bodies().setVisible(id, visible == "yes")) return Done{};
  return usage("there is no body '" + id + "'");
}

Outcome EnvironmentScript::press(const std::vector<std::string>& pixels) {
  std::vector<double> numbers;
  for (const std::string& word : pixels) {
    const auto number = toNumber(word);
    if (!number) return usage("'" + word + "' is no pixel", "Give numbers.");
    numbers.push_back(*number);
  }
  const auto send = [&](QEvent::Type type, const QPointF& at) {
    QMouseEvent event(type, at, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.scene().widget(), &event);
  };
  const QPointF from(numbers[0], numbers[1]);
  const QPointF to(numbers[numbers.size() - 2], numbers.back());
  send(QEvent::MouseButtonPress, from);
  constexpr int kMoves = 8;
  for (int i = 1; i <= kMoves && to != from; ++i) send(QEvent::MouseMove, from + (to - from) * i / kMoves);
  send(QEvent::MouseButtonRelease, to);
  return Done{};
}

Outcome EnvironmentScript::setAttribute(const std::string& name, const std::string& value) {
  SemanticDocument& document = window_.environment().document();
  if (document.selection() == SemanticSelection{})
    return usage("nothing is selected", "Select a place or a body first.");
  document.endGesture();
  return document.setAttribute(document.selection().shown(), name,
                               value == "-" ? std::nullopt : std::optional<AttributeValue>(valueOf(value)));
}

/// Key by key, and not committed.
Outcome EnvironmentScript::type(const std::string& name, const std::string& text) {
  const QString id = QString::fromStdString("attribute-" + name);
  auto* editor = window_.environment().semanticsPanel()->findChild<QWidget*>(id);
  if (editor == nullptr) return usage("there is no editor of '" + name + "'", "Select a place or a body first.");
  editor->setFocus(Qt::TabFocusReason);
  for (const QChar key : QString::fromStdString(text)) {
    QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, key);
    QApplication::sendEvent(editor, &event);
  }
  return Done{};
}

Outcome EnvironmentScript::define(const std::string& name, const std::string& type, const std::string& owner) {
  AttributeDefinition definition;
  const auto known = attributeTypeByName(type);
  if (!known) return usage("there is no type '" + type + "'");
  definition.name = definition.label = name;
  definition.type = *known;
  definition.owner = owner == "body" ? AttributeOwner::Body : AttributeOwner::Place;
  definition.initial = initialValue(definition);
  return window_.environment().document().addDefinition(definition);
}

Outcome EnvironmentScript::expectAttribute(const std::string& name, const std::string& value) {
  const SemanticDocument& document = window_.environment().document();
  const auto check = [&](const ProvenValue& found) -> Outcome {
    if (toText(found.value) == value) return Done{};
    return unmet("'" + name + "' is " + toText(found.value) + ", not " + value);
  };
  const SemanticSelection shown = document.selection().shown();
  const AttributeOwner owner = shown.owner();
  if (document.table().find(owner, name) == nullptr) return usage("there is no attribute '" + name + "'");
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

Outcome EnvironmentScript::expectWay(const std::string& names) {
  std::string way;
  if (const CoarsePlanPtr& plan = window_.environment().shownPlan()) {
    for (const TopologicalStep& step : plan->steps) way += (way.empty() ? "" : ",") + step.placeName;
  }
  if (way == names) return Done{};
  return unmet("the coarse path leads through " + (way.empty() ? "nothing" : way) + ", not " + names);
}

Outcome EnvironmentScript::expectStep(const std::string& name) {
  const auto step = window_.environment().planPanel()->currentStep();
  const std::string found = step ? window_.environment().shownPlan()->steps[*step].placeName : "-";
  return found == name ? Outcome(Done{}) : unmet("the step that is highlighted is " + found + ", not " + name);
}

Outcome EnvironmentScript::expectPlan(const std::string& what) {
  const CoarsePlanPtr& plan = window_.environment().shownPlan();
  const std::string found = !plan ? "none" : plan->attempt == 0 ? "preview" : "tried";
  return found == what ? Outcome(Done{}) : unmet("the coarse plan that is shown is " + found + ", not " + what);
}

Outcome EnvironmentScript::identify(const std::string& identifier) {
  const PlaceIdentifierRegistry registry = makePlaceIdentifierRegistry();
  if (registry.find(identifier) == nullptr) return usage("places cannot be found by '" + identifier + "'");
  window_.environment().identifyPlaces(identifier);
  return Done{};
}

}  // namespace glissade
