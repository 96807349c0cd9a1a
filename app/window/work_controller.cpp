#include "app/window/work_controller.h"

#include <utility>

namespace glissade {

WorkController::WorkController(SessionBridge& bridge, const ActionCatalogue& actions, QStatusBar& bar)
    : QObject(&bar),
      bridge_(bridge),
      cancel_(actions[QStringLiteral("work.cancel")]),
      busy_(new BusyBar(cancel_, &bar)),
      atOnce_(bridge.clock() == SessionClock::Lockstep) {
  bar.addPermanentWidget(busy_);
  busy_->hide();
  connect(cancel_, &QAction::triggered, this, [this] { cancelAll(); });
  connect(&task_, &BackgroundTask::progressed, busy_, &BusyBar::setShare);
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

void WorkController::begin(const Job& job) {
  task_.start(job.work, atOnce_);
  if (!task_.isBusy()) return;
  toTheEnd_ = job.toTheEnd;
  smoothing_ = false;
  busy_->begin(job.what);
  enable();
}

void WorkController::cancel() {
  waiting_.reset();
  if (!toTheEnd_) task_.cancel();
}

void WorkController::showSnapshot(const SessionSnapshot& snapshot) {
  if (task_.isBusy() || (!snapshot.smoothing && !smoothing_)) return;
  if (!smoothing_) busy_->begin(tr("Smoothing the path"));
  smoothing_ = snapshot.smoothing.has_value();
  if (smoothing_) {
    busy_->setShare(*snapshot.smoothing);
  } else {
    busy_->end();
  }
  enable();
}

void WorkController::cancelAll() {
  if (task_.isBusy()) {
    task_.cancel();
  } else {
    bridge_.post(command::Stop{});
  }
}

void WorkController::enable() { cancel_->setEnabled(task_.isBusy() || smoothing_); }

}  // namespace glissade
