#include "app/window/work_controller.h"

#include <utility>

namespace glissade {
namespace {

/// "Reading the parts" as the middle of a sentence.
std::string inSentence(QString what) {
  if (!what.isEmpty()) what[0] = what[0].toLower();
  return what.toStdString();
}

}  // namespace

WorkController::WorkController(SessionBridge& bridge, const ActionCatalogue& actions, QStatusBar& bar)
    : QObject(&bar),
      bridge_(bridge),
      cancel_(actions[QStringLiteral("work.cancel")]),
      busy_(new BusyBar(cancel_, &bar)),
      atOnce_(bridge.clock() == SessionClock::Lockstep) {
  bar.addPermanentWidget(busy_);
  busy_->hide();
  connect(&bridge, &SessionBridge::snapshotChanged, this,
          [this](const SnapshotPtr& snapshot) { followRun(*snapshot); });
  connect(cancel_, &QAction::triggered, this, [this] { cancelAll(); });
  connect(&task_, &BackgroundTask::progressed, busy_, &BusyBar::setShare);
  connect(&task_, &BackgroundTask::failed, this, &WorkController::reportFailure);
  connect(&task_, &BackgroundTask::ended, this, [this] {
    busy_->end();
    toTheEnd_ = false;
    if (const auto next = std::exchange(waiting_, std::nullopt)) begin(*next);
    enable();
  });
  enable();
}

void WorkController::run(const Job& job) {
  if (toTheEnd_) {
    waiting_ = job;
  } else {
    begin(job);
  }
}

void WorkController::show(const BackgroundTask& task, const QString& what, const std::function<void()>& cancel) {
  connect(&task, &BackgroundTask::started, this, [this, what, cancel] { beginOther(what, cancel); });
  connect(&task, &BackgroundTask::progressed, this, &WorkController::showShare);
  connect(&task, &BackgroundTask::ended, this, &WorkController::endOther);
}

void WorkController::beginOther(const QString& what, const std::function<void()>& cancel) {
  cancelOther_ = cancel;
  if (!task_.isBusy()) busy_->begin(what);
  enable();
}

void WorkController::showShare(double share) {
  if (!task_.isBusy()) busy_->setShare(share);
}

void WorkController::endOther() {
  cancelOther_ = nullptr;
  if (!task_.isBusy()) busy_->end();
  enable();
}

void WorkController::begin(const Job& job) {
  reportedFailure_.clear();
  task_.start(inSentence(job.what), job.work, atOnce_);
  if (!task_.isBusy()) return;
  toTheEnd_ = job.toTheEnd;
  pathWork_ = false;
  busy_->begin(job.what);
  enable();
}

void WorkController::cancel() {
  waiting_.reset();
  if (!toTheEnd_) task_.cancel();
}

void WorkController::followRun(const SessionSnapshot& snapshot) {
  if (task_.isBusy() || (!snapshot.pathWork && !pathWork_)) return;
  if (!pathWork_) {
    const bool smoothing = snapshot.pathWork->kind == PathWork::Kind::Smoothing;
    busy_->begin(smoothing ? tr("Smoothing the path") : tr("Examining the path"));
  }
  pathWork_ = snapshot.pathWork.has_value();
  if (pathWork_) {
    busy_->setShare(snapshot.pathWork->share);
  } else {
    busy_->end();
  }
  enable();
}

void WorkController::reportFailure(const Diagnostic& why) {
  failure_ = why;
  const std::string text = toString(why);
  if (std::exchange(reportedFailure_, text) != text) emit failed(why);
}

void WorkController::cancelAll() {
  if (task_.isBusy()) {
    task_.cancel();
  } else if (cancelOther_) {
    const auto cancelOther = cancelOther_;  // it is forgotten on the way
    cancelOther();
  } else {
    bridge_.post(command::Stop{});
  }
}

void WorkController::enable() { cancel_->setEnabled(task_.isBusy() || cancelOther_ || pathWork_); }

}  // namespace glissade
