#include "widgets/sequence/sequence_edits.h"

#include <QAction>
#include <QSignalBlocker>

#include <algorithm>
#include <numeric>

#include "engine/base/number_text.h"
#include "engine/sequence/demand_conflicts.h"
#include "engine/sequence/step_cost.h"
#include "engine/sequence/step_motion.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// The step number of a script's word, from 1; nothing if the word is no step.
std::optional<std::size_t> stepIn(const std::string& word, const SequencePanel& panel) {
  const auto number = toNumber(word);
  const std::size_t steps = panel.shown().plan ? panel.shown().plan->steps.size() : 0;
  if (!number || *number < 1.0 || *number > static_cast<double>(steps)) return std::nullopt;
  return static_cast<std::size_t>(*number) - 1;
}

/// `names`: as demands name bodies.
QString joinedNames(const std::vector<std::string>& names, const AssembledProduct& product) {
  return glissade::joinedNames(std::vector<BodyId>(names.begin(), names.end()), product);
}

}  // namespace

QString joinedNames(const std::vector<BodyId>& bodies, const AssembledProduct& product) {
  QStringList names;
  for (const BodyId& id : bodies) names << QString::fromStdString(shownNameOf(id, product));
  return names.join(QStringLiteral(", "));
}

SequenceEdits::SequenceEdits(const Workbench& bench, SequenceController& sequence)
    : QObject(&sequence), bench_(bench), sequence_(sequence) {
  SequencePanel* panel = sequence.panel();
  connect(panel, &SequencePanel::stepMoved, this,
          [this](int from, int to) { move(static_cast<std::size_t>(from), static_cast<std::size_t>(to)); });
  connect(panel, &SequencePanel::directionForbidden, this,
          [this](const QString& axis) { forbid(*axisNamed(axis.toStdString())); });
  connect(panel, &SequencePanel::costChosen, this, [this](const QString& cost) {
    SequenceDemands demands = bench_.document.demands();
    demands.cost = cost.toStdString();
    set(tr("Cost of steps"), demands);
  });
  connect(panel, &SequencePanel::selectionChanged, this, &SequenceEdits::enableActions);
  connect(&panel->demandsMenu(), &QMenu::aboutToShow, this, &SequenceEdits::fillDemandsMenu);
  connectActions();
  addScriptCommands();
  enableActions();
}

void SequenceEdits::connectActions() {
  bench_.onAction("sequence.step-up", this, [this] { moveBy(-1); });
  bench_.onAction("sequence.step-down", this, [this] { moveBy(1); });
  bench_.onAction("sequence.lock", this, [this](bool locked) { lock(locked); });
  bench_.onAction("sequence.forbid-way", this, [this] { forbidWay(); });
  bench_.onAction("sequence.keep-order", this, [this] { keepOrder(); });
  bench_.onAction("sequence.free-step", this, [this] { freeSteps(); });
}

void SequenceEdits::addScriptCommands() {
  SequencePanel& panel = *sequence_.panel();
  bench_.scripts.add("move-step", 2, [this, &panel](const Words& words) -> Outcome {
    const auto from = stepIn(words[0], panel);
    const auto to = stepIn(words[1], panel);
    if (!from || !to) return wrongCommand("there is no step " + (from ? words[1] : words[0]));
    move(*from, *to);
    return Done{};
  });
  bench_.scripts.add("select-steps", 2, [&panel](const Words& words) -> Outcome {
    const auto first = stepIn(words[0], panel);
    const auto last = stepIn(words[1], panel);
    if (!first || !last) return wrongCommand("there is no step " + (first ? words[1] : words[0]));
    std::vector<std::size_t> steps;
    for (std::size_t step = *first; step <= *last; ++step) steps.push_back(step);
    return panel.selectSteps(steps) ? Outcome(Done{}) : wrongCommand("these steps are not shown");
  });
  bench_.scripts.add("expect-row", 2, [&panel](const Words& words) -> Outcome {
    const auto step = stepIn(words[0], panel);
    if (!step) return wrongCommand("there is no step " + words[0]);
    const std::string text = panel.rowText(*step).toStdString();
    if (text.find(words[1]) != std::string::npos) return Done{};
    return unmetExpectation("the row of step " + words[0] + " says '" + text + "', not '" + words[1] + "'");
  });
  bench_.scripts.add("forbid-direction", 1, [this](const Words& words) -> Outcome {
    const auto axis = axisNamed(words[0]);
    if (!axis) return wrongCommand("'" + words[0] + "' is no axis", "Say +x, -x, +y, -y, +z or -z.");
    if (chosenBodies().empty()) return wrongCommand("no step is chosen");
    forbid(*axis);
    return Done{};
  });
  bench_.scripts.add("set-cost", 1, [&panel](const Words& words) -> Outcome {
    emit panel.costChosen(QString::fromStdString(words[0]));
    return Done{};
  });
}

void SequenceEdits::set(const QString& text, const SequenceDemands& demands) {
  const Result<StepCost> cost = StepCost::of(demands);
  if (!cost) {
    bench_.messages.showError(tr("The sequence cannot be planned with these constraints"), cost.error());
    sequence_.panel()->setCost(bench_.document.demands().cost);
    return;
  }
  const SequenceDemands& present = bench_.document.demands();
  const DemandConflict conflict = conflictBetween(present, demands);
  if (conflict.isNone()) {
    bench_.document.setDemands(text, demands);
  } else if (bench_.messages.isNewDemandPreferred(tr("Two constraints exclude each other"), inWords(conflict))) {
    bench_.document.setDemands(text, withoutEarlier(conflict, demands));
  }
}

std::vector<BodyId> SequenceEdits::chosenBodies() const {
  const SequencePanel& panel = *sequence_.panel();
  std::vector<BodyId> bodies;
  for (const std::size_t step : panel.selectedSteps()) {
    for (const BodyId& id : panel.shown().plan->steps[step].bodies()) bodies.push_back(id);
  }
  if (bodies.empty() && !panel.chosenStuck().empty()) bodies.push_back(panel.chosenStuck());
  return bodies;
}

std::vector<ForbiddenCone> SequenceEdits::forbiddenCones(const std::vector<SequenceBody>& bodies) const {
  std::vector<ForbiddenCone> cones;
  if (!sequence_.shown().plan) return cones;
  const AssembledProduct& product = *sequence_.shown().product;
  const std::vector<BodyId> chosen = chosenBodies();
  for (const ForbiddenDirection& each : bench_.document.demands().forbidden) {
    for (const std::size_t body : bodiesNamed(product, each.body)) {
      const RigidBody& own = product.bodies[body];
      if (std::find(chosen.begin(), chosen.end(), own.id) == chosen.end()) continue;
      const Box3 box = boundingBox(*own.mesh);
      const Pose& X_WB = bodies.empty() ? own.X_WB : bodies[body].X_WB;
      cones.push_back({X_WB * box.center(), each.direction.normalized(), box.diagonal().norm()});
    }
  }
  return cones;
}

void SequenceEdits::move(std::size_t from, std::size_t to) {
  if (!sequence_.isEditable()) return;
  const ShownPlan& shown = sequence_.shown();
  const QString name = joinedNames(shown.plan->steps[from].bodies(), *shown.product);
  const SequenceDemands& demands = bench_.document.demands();
  sequence_.moveStep({tr("%1 as step %2").arg(name).arg(rowOf(to + 1)), withStepMoved(from, to, *shown.plan, demands),
                      orderWithStepMoved(from, to, *shown.plan, demands),
                      shown.plan->steps[from].motions.front().body});
}

/// The number in the table of the step with this place of removal.
std::size_t SequenceEdits::rowOf(std::size_t place) const {
  const std::size_t steps = sequence_.shown().plan->steps.size();
  const bool assembly = sequence_.panel()->order() == PlanOrder::Assembly && place <= steps;
  return assembly ? steps + 1 - place : place;
}

void SequenceEdits::moveBy(int rows) {
  const SequencePanel& panel = *sequence_.panel();
  const auto step = panel.chosenStep();
  if (!step) return;
  const bool back = (panel.order() == PlanOrder::Assembly) != (rows < 0);  // towards the start of the removal
  if (back && *step > 0) move(*step, *step - 1);
  if (!back && *step + 1 < panel.shown().plan->steps.size()) move(*step, *step + 1);
}

void SequenceEdits::lock(bool locked) {
  const ShownPlan& shown = sequence_.shown();
  SequenceDemands demands = bench_.document.demands();
  for (const std::size_t step : sequence_.panel()->selectedSteps()) {
    demands = withStepLocked(step, locked, *shown.plan, std::move(demands));
  }
  const QString name = joinedNames(chosenBodies(), *shown.product);
  std::vector<std::size_t> order(shown.plan->steps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sequence_.moveStep(
      {locked ? tr("Lock %1").arg(name) : tr("Unlock %1").arg(name), demands, order, sequence_.panel()->chosenBody()});
  enableActions();
}

void SequenceEdits::forbid(const Vector3& direction) {
  const QString name = joinedNames(chosenBodies(), *sequence_.shown().product);
  const QString way = QString::fromStdString(windowPlanWords().direction(direction));
  set(tr("%1 not %2").arg(name, way), withForbidden(chosenBodies(), direction, bench_.document.demands()));
}

void SequenceEdits::forbidWay() {
  const ShownPlan& shown = sequence_.shown();
  SequenceDemands demands = bench_.document.demands();
  for (const std::size_t step : sequence_.panel()->selectedSteps()) {
    for (const StepMotion& motion : shown.plan->steps[step].motions) {
      demands = withForbidden(motion.bodies(), firstDirection(motion.path), std::move(demands));
    }
  }
  set(tr("Rule out the direction of %1").arg(joinedNames(chosenBodies(), *shown.product)), demands);
}

void SequenceEdits::keepOrder() {
  std::vector<std::vector<BodyId>> steps;
  for (const std::size_t step : sequence_.panel()->selectedSteps()) {
    steps.push_back(sequence_.shown().plan->steps[step].bodies());
  }
  set(tr("Keep the order of %1").arg(joinedNames(chosenBodies(), *sequence_.shown().product)),
      withOrder(steps, bench_.document.demands()));
}

void SequenceEdits::freeSteps() {
  set(tr("No constraints on %1").arg(joinedNames(chosenBodies(), *sequence_.shown().product)),
      withoutDemandsOn(chosenBodies(), bench_.document.demands()));
}

/// Fills the menu of demands. Each entry removes its demand.
void SequenceEdits::fillDemandsMenu() {
  QMenu& menu = sequence_.panel()->demandsMenu();
  menu.clear();
  const SequenceDemands& demands = bench_.document.demands();
  const AssembledProduct& product = *sequence_.shown().product;
  const auto add = [&](const QString& text, const std::function<void(SequenceDemands&)>& remove) {
    connect(menu.addAction(text), &QAction::triggered, this, [this, text, remove] {
      SequenceDemands without = bench_.document.demands();
      remove(without);
      set(tr("Remove: %1").arg(text), without);
    });
  };
  const auto removal = [](auto member, const auto& each) {
    return [member, each](SequenceDemands& without) { std::erase(without.*member, each); };
  };
  for (const DemandedPlace& each : demands.places) {
    const QString names = joinedNames(each.bodies, product);
    add((each.locked ? tr("%1 is locked as step %2") : tr("%1 is placed as step %2")).arg(names).arg(rowOf(each.place)),
        removal(&SequenceDemands::places, each));
  }
  for (const DemandedMotion& each : demands.motions) {
    const QString names = joinedNames(each.bodies, product);
    add(each.method == kByHand ? tr("%1 is removed by the motion by hand").arg(names)
                               : tr("%1 keeps its motion").arg(names),
        removal(&SequenceDemands::motions, each));
  }
  for (const ForbiddenDirection& each : demands.forbidden) {
    const QString way = QString::fromStdString(windowPlanWords().direction(each.direction));
    add(tr("%1 is not removed %2").arg(joinedNames({each.body}, product), way),
        removal(&SequenceDemands::forbidden, each));
  }
  for (const auto& each : demands.before) {
    add(tr("%1 is removed before %2").arg(joinedNames({each.first}, product), joinedNames({each.second}, product)),
        removal(&SequenceDemands::before, each));
  }
  for (const auto& each : demands.together) {
    add(tr("%1 are removed as one").arg(joinedNames(each, product)), removal(&SequenceDemands::together, each));
  }
  if (menu.isEmpty()) menu.addAction(tr("None"))->setEnabled(false);
}

void SequenceEdits::enableActions() {
  const SequencePanel& panel = *sequence_.panel();
  const bool editable = sequence_.isEditable();
  const auto steps = editable ? panel.selectedSteps() : std::vector<std::size_t>();
  const std::size_t count = panel.shown().plan ? panel.shown().plan->steps.size() : 0;
  const bool one = steps.size() == 1;
  const bool assembly = panel.order() == PlanOrder::Assembly;
  const bool isFirst = one && steps.front() == (assembly ? count - 1 : 0);
  const bool isLast = one && steps.front() == (assembly ? 0 : count - 1);
  bench_.enable("sequence.step-up", one && !isFirst);
  bench_.enable("sequence.step-down", one && !isLast);
  bench_.enable("sequence.lock", !steps.empty());
  bench_.enable("sequence.forbid-way", !steps.empty());
  bench_.enable("sequence.keep-order", steps.size() > 1);
  const auto bodies = editable ? chosenBodies() : std::vector<BodyId>();
  bool demanded = false;
  bool locked = !steps.empty();
  const SequenceDemands& demands = bench_.document.demands();
  for (const BodyId& body : bodies) demanded = demanded || withoutDemandsOn({body}, demands) != demands;
  for (const std::size_t step : steps) {
    locked = locked && demandsOn(panel.shown().plan->steps[step].bodies(), demands).isLocked();
  }
  bench_.enable("sequence.free-step", demanded);
  const QSignalBlocker block(bench_.actions["sequence.lock"]);
  bench_.actions["sequence.lock"]->setChecked(locked);
}

}  // namespace glissade
