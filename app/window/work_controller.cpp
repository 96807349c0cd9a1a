#include "app/window/work_controller.h"

#include <QLocale>

#include <utility>

namespace glissade {
namespace {

/// Seconds: the end of what takes longer is told in the status bar.
constexpr double kTellFrom = 3.0;
constexpr int kTellMilliseconds = 8000;

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
      bar_(&bar),
      atOnce_(bridge.clock() == SessionClock::Lockstep) {
  bar.addPermanentWidget(busy_);
  busy_->hide();
  connect(&bridge, &SessionBridge::snapshotChanged, this,
          [this](const SnapshotPtr& snapshot) { followRun(*snapshot); });
  connect(cancel_, &QAction::triggered, this, [this] { cancelAll(); });
  connect(&task_, &BackgroundTask::progressed, busy_, &BusyBar::setShare);
  connect(&task_, &BackgroundTask::failed, this, &WorkController::reportFailure);
  connect(&task_, &BackgroundTask::ended, this, [this] {
    endBar();
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

void WorkController::show(const BackgroundTask& task, const std::function<QString()>& what,
                          const std::function<void()>& cancel) {
  connect(&task, &BackgroundTask::started, this, [this, what, cancel] { beginOther(what(), cancel); });
  connect(&task, &BackgroundTask::progressed, this, &WorkController::showShare);
  connect(&task, &BackgroundTask::ended, this, &WorkController::endOther);
}

void WorkController::beginOther(const QString& what, const std::function<void()>& cancel, Loss loss) {
  cancelOther_ = cancel;
  endangered_ = loss == Loss::Asked ? what : QString();
  if (!task_.isBusy()) beginBar(what);
  enable();
}

void WorkController::showShare(double share) {
  if (!task_.isBusy()) busy_->setShare(share);
}

void WorkController::endOther() {
  cancelOther_ = nullptr;
  endangered_.clear();
  if (!task_.isBusy()) endBar();
  enable();
}

void WorkController::begin(const Job& job) {
  reportedFailure_.clear();
  task_.start(inSentence(job.what), job.work, atOnce_);
  if (!task_.isBusy()) return;
  toTheEnd_ = job.toTheEnd;
  pathWork_ = false;
  beginBar(job.what);
  enable();
}

void WorkController::cancel() {
  waiting_.reset();
  if (toTheEnd_) return;
  cancelled_ = true;
  task_.cancel();
}

void WorkController::followRun(const SessionSnapshot& snapshot) {
  if (task_.isBusy() || (!snapshot.pathWork && !pathWork_)) return;
  if (!pathWork_) {
    const bool smoothing = snapshot.pathWork->kind == PathWork::Kind::Smoothing;
    beginBar(smoothing ? tr("Smoothing the path") : tr("Examining the path"));
  }
  pathWork_ = snapshot.pathWork.has_value();
  if (pathWork_) {
    busy_->setShare(snapshot.pathWork->share);
  } else {
    endBar();
  }
  enable();
}

void WorkController::reportFailure(const Diagnostic& why) {
  failure_ = why;
  const std::string text = toString(why);
  if (std::exchange(reportedFailure_, text) != text) emit failed(why);
}

void WorkController::beginBar(const QString& what) {
  shown_ = what;
  cancelled_ = false;
  busy_->begin(what);
}

void WorkController::endBar() {
  const double seconds = busy_->elapsedSeconds();
  busy_->end();
  const QString what = std::exchange(shown_, QString());
  if (what.isEmpty() || seconds < kTellFrom) return;
  const QString time = QLocale().toString(seconds, 'f', 0);
  bar_->showMessage(
      cancelled_ ? tr("%1: cancelled after %2 s").arg(what, time) : tr("%1: ended after %2 s").arg(what, time),
      kTellMilliseconds);
}

void WorkController::cancelAll() {
  cancelled_ = true;
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
