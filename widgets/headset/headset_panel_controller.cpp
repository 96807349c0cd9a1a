#include "widgets/headset/headset_panel_controller.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QEvent>
#include <QMessageBox>

#include <algorithm>

#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/queued_once.h"
#include "widgets/run/refusal_controller.h"
#include "widgets/sequence/sequence_controller.h"
#include "widgets/workbench/status_text.h"

namespace glissade {

HeadsetQuestions::HeadsetQuestions(HeadsetPage& page) : page_(page), showSoon_(queuedOnce(this, [this] { show(); })) {
  connect(&page, &HeadsetPage::answered, this, &HeadsetQuestions::answer);
  qApp->installEventFilter(this);
}

bool HeadsetQuestions::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
    auto* dialog = qobject_cast<QDialog*>(watched);
    if (dialog != nullptr && dialog->isModal()) {
      open_.erase(std::remove(open_.begin(), open_.end(), dialog), open_.end());
      if (event->type() == QEvent::Show) open_.emplace_back(dialog);
      showSoon_();
    }
  }
  return QObject::eventFilter(watched, event);
}

void HeadsetQuestions::show() {
  open_.erase(std::remove(open_.begin(), open_.end(), nullptr), open_.end());
  if (open_.empty()) {
    page_.ask({}, {}, {});
    return;
  }
  const auto* message = qobject_cast<QMessageBox*>(open_.back().data());
  if (message == nullptr) {
    page_.ask(open_.back()->windowTitle(),
              QCoreApplication::translate("HeadsetQuestions",
                                          "This dialog is in the window. Take the headset off to answer it."),
              {QCoreApplication::translate("HeadsetQuestions", "Close it")});
    return;
  }
  QStringList answers;
  for (const QAbstractButton* button : message->buttons()) answers << withoutMnemonic(button->text());
  page_.ask(message->text(), message->informativeText(), answers);
}

void HeadsetQuestions::answer(int chosen) const {
  if (open_.empty() || !open_.back()) return;
  if (const auto* message = qobject_cast<QMessageBox*>(open_.back().data())) {
    const QList<QAbstractButton*> buttons = message->buttons();
    if (chosen < buttons.size()) buttons[chosen]->click();
  } else {
    open_.back()->reject();
  }
}

HeadsetPanelController::HeadsetPanelController(const Workbench& bench, const RefusalController& refusal,
                                               SequenceController& sequence, const MeasuringTools& measuring)
    : QObject(&bench.window),
      bench_(bench),
      refusal_(refusal),
      sequence_(sequence),
      texts_(bench, tools_),
      walk_(bench, sequence),
      handTools_(bench, measuring) {
  Headset* headset = bench.scene.headset();
  if (headset == nullptr) return;
  headset->setTools(tools_);
  connect(&walk_, &InstructionWalk::hintChanged, this, [this] { texts_.setHint(walk_.hint()); });
  connect(bench.actions["view.headset"], &QAction::toggled, this, [this](bool on) {
    if (on && !page_) make();
    texts_.setOn(on);
  });
  connect(bench.actions["headset.panel-in-front"], &QAction::toggled, this,
          [this](bool inFront) { tools_->panelInFront = inFront; });
}

void HeadsetPanelController::make() {
  page_ = std::make_unique<HeadsetPage>(bench_.actions);
  view_ = std::make_unique<HeadsetPanelView>(*page_, tools_);
  questions_ = std::make_unique<HeadsetQuestions>(*page_);
  connect(page_.get(), &HeadsetPage::commanded, &bench_.session, &SessionBridge::post);
  connect(page_.get(), &HeadsetPage::viewChosen, this,
          [this](int view) { emit viewChosen(views_[static_cast<std::size_t>(view)]); });
  connect(&bench_.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & (Change::Scenario | Change::Arrangement)) showScenario();
  });
  connect(&bench_.run, &ShownRun::changed, this, &HeadsetPanelController::showRun);
  connect(&bench_.run, &ShownRun::liveChanged, this, [this](bool live) { page_->setReplayed(!live); });
  connect(&refusal_.bar(), &NoticeBar::changed, this, &HeadsetPanelController::showRefusal);
  connect(sequence_.panel(), &SequencePanel::sceneChanged, this, &HeadsetPanelController::showStep);
  connect(&sequence_, &SequenceController::planShown, this, &HeadsetPanelController::showStep);
  page_->setReplayed(!bench_.run.isLive());
  setViews(views_);
  showScenario();
  showRefusal();
  showStep();
}

void HeadsetPanelController::setViews(const NamedViews& views) {
  views_ = views;
  if (!page_) return;
  QStringList names;
  for (const NamedView& view : views_) names << view.name;
  page_->setViews(names);
}

void HeadsetPanelController::showScenario() {
  if (bench_.document.scenario()) page_->setScenario(*bench_.document.scenario());
  showRun();
}

/// Shows the run. Before a run the text is empty, because the status line then explains keys.
void HeadsetPanelController::showRun() {
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  if (!snapshot) return;
  const bool hasRun = snapshot->state != SessionState::Idle && !snapshot->problem;
  page_->setSnapshot(*snapshot, bench_.session.deviceId(), hasRun ? statusText(*snapshot) : QString());
}

void HeadsetPanelController::showRefusal() {
  const NoticeBar& bar = refusal_.bar();
  if (bar.isHidden()) {
    page_->setRefusal({}, {});
  } else {
    page_->setRefusal(bar.notice().title, bar.notice().details);
  }
}

void HeadsetPanelController::showStep() { page_->setStep(sequence_.panel()->placeText()); }

}  // namespace glissade
