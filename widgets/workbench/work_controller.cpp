#include "widgets/workbench/work_controller.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace glissade {
namespace {

/// Work that took at least so many seconds announces its end in the status bar.
constexpr double kTellFrom = 3.0;
constexpr int kTellMilliseconds = 8000;

/// The text in the middle of a sentence: "reading the parts".
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
  connect(cancel_, &QAction::triggered, this, [this] { cancelShown(); });
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
  connect(&task, &BackgroundTask::started, this, [this, &task, what, cancel] { beginOther(task, what(), cancel); });
  connect(&task, &BackgroundTask::progressed, this, [this, &task](double share) { showShare(task, share); });
  connect(&task, &BackgroundTask::ended, this, [this, &task] { endOther(task); });
}

void WorkController::beginOther(const QObject& owner, const QString& what, const std::function<void()>& cancel,
                                Loss loss) {
  others_.push_back({&owner, what, cancel, loss, startedNow()});
  if (!task_.isBusy()) beginBar(what, others_.back().since);
  enable();
}

QString WorkController::endangered() const {
  for (const Other& other : others_) {
    if (other.loss == Loss::Asked) return other.what;
  }
  return {};
}

void WorkController::showShare(const QObject& owner, double share) {
  const bool shown = !task_.isBusy() && !pathWork_ && !others_.empty() && others_.back().owner == &owner;
  if (shown) busy_->setShare(share);
}

void WorkController::endOther(const QObject& owner) {
  const auto ended =
      std::find_if(others_.begin(), others_.end(), [&](const Other& other) { return other.owner == &owner; });
  if (ended == others_.end()) return;
  const bool shown = !task_.isBusy() && !pathWork_ && ended + 1 == others_.end();
  others_.erase(ended);
  if (shown) endBar();
  enable();
}

void WorkController::begin(const Job& job) {
  reportedFailure_.clear();
  task_.start(Message(inSentence(job.what)), job.work, atOnce_);
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

QElapsedTimer WorkController::startedNow() {
  QElapsedTimer timer;
  timer.start();
  return timer;
}

void WorkController::beginBar(const QString& what, const QElapsedTimer& since) {
  shown_ = what;
  cancelled_ = false;
  busy_->begin(what, since);
}

void WorkController::endBar() {
  const double seconds = busy_->elapsedSeconds();
  busy_->end();
  const QString what = std::exchange(shown_, QString());
  const bool cancelled = cancelled_;
  if (!others_.empty()) beginBar(others_.back().what, others_.back().since);
  // The result of the work, such as the file that it has saved, is more than that it has ended.
  if (what.isEmpty() || seconds < kTellFrom || !bar_->currentMessage().isEmpty()) return;
  const QString time = QLocale().toString(seconds, 'f', 0);
  bar_->showMessage(
      cancelled ? tr("%1: cancelled after %2 s").arg(what, time) : tr("%1: ended after %2 s").arg(what, time),
      kTellMilliseconds);
}

void WorkController::cancelShown() {
  cancelled_ = true;
  if (task_.isBusy()) {
    task_.cancel();
  } else if (!pathWork_ && !others_.empty()) {
    const auto cancelOther = others_.back().cancel;  // cancelling removes the entry
    cancelOther();
  } else {
    bridge_.post(command::Stop{});
  }
}

void WorkController::enable() {
  cancel_->setEnabled(isBusy());
  emit busyChanged();
}

}  // namespace glissade
