#include "widgets/bridge/background_task.h"

namespace glissade {
namespace {

constexpr int kLookMilliseconds = 100;

}  // namespace

BackgroundTask::BackgroundTask(QObject* parent) : QObject(parent) {
  look_.setInterval(kLookMilliseconds);
  connect(&look_, &QTimer::timeout, this, [this] { emit progressed(share_->load()); });
}

BackgroundTask::~BackgroundTask() {
  ++request_;
  stop_.requestStop();
  for (Worker& worker : workers_) worker.thread.join();
}

void BackgroundTask::cancel() {
  ++request_;
  stop_.requestStop();
  end();
}

void BackgroundTask::end() {
  if (!busy_) return;
  busy_ = false;
  look_.stop();
  emit ended();
}

void BackgroundTask::joinFinished() {
  for (auto worker = workers_.begin(); worker != workers_.end();) {
    if (!worker->done) {
      ++worker;
      continue;
    }
    worker->thread.join();
    worker = workers_.erase(worker);
  }
}

void BackgroundTask::start(const Work& work, bool atOnce) {
  cancel();
  joinFinished();
  stop_ = StopSource();
  if (atOnce) {
    const std::uint64_t request = request_;
    deliver(request, work(stop_.token()));
    return;
  }
  share_ = std::make_shared<std::atomic<double>>(0.0);
  busy_ = true;
  look_.start();
  emit started();
  const WorkWatch watch(stop_.token(), [share = share_](double done) { share->store(done); });
  Worker& worker = workers_.emplace_back();
  worker.thread = std::thread([this, work, watch, request = request_, done = &worker.done] {
    const Delivery delivery = work(watch);
    QMetaObject::invokeMethod(
        this, [this, request, delivery] { deliver(request, delivery); }, Qt::QueuedConnection);
    *done = true;
  });
}

void BackgroundTask::deliver(std::uint64_t request, const Delivery& delivery) {
  if (request != request_) return;
  end();
  delivery();
}

}  // namespace glissade
