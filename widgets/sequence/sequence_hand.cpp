#include "widgets/sequence/sequence_hand.h"

#include <QAction>
#include <QKeyEvent>
#include <algorithm>

#include "engine/documents/plan_tasks.h"
#include "engine/files/hand_run.h"
#include "engine/operator/device_registry.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/sequence/demand_conflicts.h"
#include "engine/sequence/demand_edits.h"
#include "widgets/sequence/sequence_controller.h"
#include "widgets/sequence/sequence_edits.h"

namespace glissade {
SequenceHand::SequenceHand(const Workbench& bench, SequenceController& sequence)
    : QObject(&sequence),
      bench_(bench),
      sequence_(sequence),
      banner_(new NoticeBar(bench.actions, bench.scene.widget(), kRoomForViewCube)) {
  banner_->setObjectName(QStringLiteral("hand-banner"));
  connect(banner_, &NoticeBar::closed, this, [this] { goBack({}); });
  bench.scene.widget()->installEventFilter(this);  // tools that are in use take the Escape key before
  bench.onAction("sequence.by-hand", this, [this] { begin(); });
  bench.onAction("sequence.take-path", this, [this] { takePath(); });
  bench.onAction("sequence.leave-hand", this, [this] { goBack({}); });
  connect(&bench.document, &WorkbenchDocument::changed, this, &SequenceHand::followDocument);
  connect(&bench.document.undoStack(), &QUndoStack::indexChanged, this, &SequenceHand::followUndo);
  connect(sequence.panel(), &SequencePanel::selectionChanged, this, &SequenceHand::enableActions);
  enableActions();
}

void SequenceHand::begin() {
  SequencePanel& panel = *sequence_.panel();
  const ShownPlan shown = sequence_.shown();
  Run run{shown, {panel.chosenStuck()}, panel.chosenStep()};
  const auto& steps = shown.plan->steps;
  const StepMotion* motion = run.step ? &steps[*run.step].motions.front() : nullptr;
  if (motion != nullptr) run.bodies = motion->bodies();
  std::vector<BodyId> gone;
  for (std::size_t i = 0; i < run.step.value_or(steps.size()); ++i) {
    for (const BodyId& id : steps[i].bodies()) gone.push_back(id);
  }
  run_ = run;
  const auto joints = motion != nullptr ? motion->joints : std::vector<StepJoint>();
  const auto change = [this, bodies = run.bodies, gone, joints](Scenario& scenario) {
    return prepareHandRun(bodies, gone, *bench_.document.scenario(), joints, scenario);
  };
  const Outcome edited = bench_.document.editTemporarily(tr("Move %1 by hand").arg(nameOf(run)), change);
  if (!edited) {
    run_.reset();
    bench_.messages.showError(tr("The step cannot be moved by hand"), edited.error());
    enableActions();
    return;
  }
  bench_.document.whenArranged([this] { noteBegun(); });
}

QString SequenceHand::nameOf(const Run& run) const { return joinedNames(run.bodies, *run.plan.product); }

bool SequenceHand::hasObject() const {
  const std::vector<RigidBody>& object = bench_.document.scenario()->objectBodies;
  return object.size() == run_->bodies.size() &&
         std::all_of(object.begin(), object.end(), [this](const RigidBody& body) {
           return std::find(run_->bodies.begin(), run_->bodies.end(), body.id) != run_->bodies.end();
         });
}

void SequenceHand::noteBegun() {
  if (!run_ || run_->begun) return;
  if (!hasObject()) {  // the edit failed and was reported
    end();
  } else {
    run_->begun = true;
    bench_.document.semantics().select({});  // the marks of blocking bodies would hide the part in the hand
    takeInHand();
    showBanner();
    bench_.scene.widget()->setFocus();  // for the keys that move the part
    emit activityChanged();
  }
  enableActions();
}

void SequenceHand::takeInHand() {
  const DeviceRegistry devices = makeDeviceRegistry();
  const DeviceEntry* device = devices.find(bench_.session.deviceId());
  if (device == nullptr || device->simulated) bench_.session.setDevice(kAnyDevice);
  run_->strategy = bench_.document.settings().strategy;
  bench_.session.post(command::SetPlanner{"by-hand"});
}

void SequenceHand::showBanner() {
  const QString name = nameOf(*run_);
  QString title = tr("%1 by hand").arg(name);
  if (run_->step) {
    const std::string number = stepNumber(run_->plan.plan->steps.size() - 1 - *run_->step);
    title = tr("Step %1 by hand: %2").arg(QString::fromStdString(number), name);
  }
  banner_->showNotice({title,
                       tr("Find path (F5) begins a run. Its certified path becomes the step. Esc goes back."),
                       {"sequence.take-path", "sequence.leave-hand", "run.finish"}});
}

bool SequenceHand::eventFilter(QObject* watched, QEvent* event) {
  const bool escape = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
  if (!escape || !run_ || !run_->begun || goingBack_) return QObject::eventFilter(watched, event);
  goBack({});
  return true;
}

void SequenceHand::end() {
  const std::string strategy = run_->strategy;
  run_.reset();
  banner_->hide();
  if (!strategy.empty()) bench_.session.post(command::SetPlanner{strategy});
  enableActions();
  emit activityChanged();
}

void SequenceHand::followDocument(Changes what) {
  if (!run_) return;
  if (what & Change::Scenario) {
    run_->strategy.clear();  // another scenario has its own
    end();
  } else if ((what & Change::Results) && run_->begun && bench_.document.results().path) {
    followPath();
  }
  enableActions();
}

void SequenceHand::followPath() {
  if (bench_.document.results().smoothed) {
    // Taking the path ends the session that announces it, so it is taken later.
    QMetaObject::invokeMethod(this, &SequenceHand::takePath, Qt::QueuedConnection);
  } else if (!run_->smoothing) {
    run_->smoothing = true;
    bench_.session.post(command::SmoothPath{kUsualShortcuts});
  }
}

/// Ends the run after a person has undone its scenario.
void SequenceHand::followUndo() {
  if (!run_ || !run_->begun || goingBack_ || bench_.document.isTemporary()) return;
  end();
  sequence_.showRemembered();
}

void SequenceHand::goBack(const std::function<void()>& then) {
  if (!run_ || !run_->begun || goingBack_) return;
  goingBack_ = true;
  bench_.session.forgetPath();  // the path belongs to other bodies
  bench_.document.endTemporary();
  bench_.document.whenArranged([this, then] {
    goingBack_ = false;
    end();
    sequence_.bringToFront();  // the run had raised the panel of its path
    if (then) then();
  });
}

void SequenceHand::takePath() {
  const std::shared_ptr<const Path> path = bench_.document.results().path;
  if (!run_ || !run_->begun || goingBack_ || !path || path->points.size() < 2) return;
  if (!hasObject()) return;
  const ShownPlan& shown = run_->plan;
  std::vector<RigidBody> bodies;
  for (const BodyId& id : run_->bodies) bodies.push_back(shown.product->body(id));
  const DemandedMotion motion = motionOfRun(bodies, path->points, bench_.document.results().provenance);
  const SequenceDemands& present = bench_.document.demands();
  const DemandConflict conflict = conflictBetween(present, withMotion(motion, present));
  const bool taken = conflict.isNone() ||
                     bench_.messages.isNewDemandPreferred(tr("The path uses a ruled-out direction"), inWords(conflict));
  if (!taken) return;
  const auto step = run_->step;
  const QString name = nameOf(*run_);
  const PlanPtr plan = shown.plan;
  goBack([this, motion, conflict, step, plan, name] {
    SequenceDemands demands = bench_.document.demands();
    sequence_.chooseLater(BodyId(motion.bodies.front()));
    if (step) demands = withStepMoved(*step, *step, *plan, std::move(demands));
    demands = withoutEarlier(conflict, std::move(demands));
    const bool byHand = motion.method == kByHand;
    bench_.document.setDemands(byHand ? tr("%1 by hand").arg(name) : tr("Path of %1").arg(name),
                               withMotion(motion, std::move(demands)));
    bench_.messages.showStatus(byHand ? tr("The path by hand is the motion of %1.").arg(name)
                                      : tr("The path that the computer found is the motion of %1.").arg(name));
  });
}

void SequenceHand::enableActions() {
  const SequencePanel& panel = *sequence_.panel();
  const bool chosen = panel.chosenStep() || !panel.chosenStuck().empty();
  const bool active = run_ && run_->begun;
  bench_.enable("sequence.by-hand", !run_ && sequence_.isEditable() && chosen);
  bench_.enable("sequence.take-path", active && bench_.document.results().path != nullptr);
  bench_.enable("sequence.leave-hand", active);
}

}  // namespace glissade
