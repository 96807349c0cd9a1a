#include "widgets/controls/background_task.h"

#include <iterator>

#include "engine/base/guarded.h"

namespace glissade {
namespace {

constexpr int kLookMilliseconds = 100;

}  // namespace

BackgroundTask::BackgroundTask(QObject* parent) : QObject(parent) {
  look_.setInterval(kLookMilliseconds);
  connect(&look_, &QTimer::timeout, this, [this] {
    emit progressed(share_->load());
    announceEnd();  // announces an end that a worker had no memory to announce
  });
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

void BackgroundTask::start(const Message& doing, const Work& work, bool atOnce) {
  cancel();
  collect();
  stop_ = StopSource();
  if (!atOnce) {
    startWorker(doing, work);
    return;
  }
  Found found;
  found.problem = guarded(doing, [&] { found.delivery = work(stop_.token()); });
  deliver(doing, found);
}

void BackgroundTask::startWorker(const Message& doing, const Work& work) {
  share_ = std::make_shared<std::atomic<double>>(0.0);
  busy_ = true;
  look_.start();
  emit started();
  const WorkWatch watch(stop_.token(), [share = share_](double done) { share->store(done); });
  Worker& worker = workers_.emplace_back();
  worker.request = request_;
  worker.doing = doing;
  const auto run = [this, &worker, work, watch] {
    worker.found.problem = guarded(worker.doing, [&] { worker.found.delivery = work(watch); });
    worker.done = true;
    announceEnd();  // if this fails, the timer notices that the worker is done
  };
  if (auto why = guarded(doing, [&] { worker.thread = std::thread(run); })) {
    workers_.pop_back();
    deliver(doing, {{}, std::move(why)});
  }
}

/// Queues the call behind everything that the worker has announced before.
void BackgroundTask::announceEnd() {
  (void)guarded(GLISSADE_TEXT("announcing a result"), [this] {
    QMetaObject::invokeMethod(
        this, [this] { collect(); }, Qt::QueuedConnection);
  });
}

/// Joins the workers that are done, and delivers the result of the last request.
void BackgroundTask::collect() {
  std::list<Worker> done;
  for (auto worker = workers_.begin(); worker != workers_.end();) {
    const auto next = std::next(worker);
    if (worker->done) done.splice(done.end(), workers_, worker);
    worker = next;
  }
  for (Worker& worker : done) worker.thread.join();
  for (const Worker& worker : done) {
    if (worker.request == request_) deliver(worker.doing, worker.found);
  }
}

void BackgroundTask::deliver(const Message& doing, const Found& found) {
  end();
  const auto why = found.problem ? found.problem : guarded(doing, found.delivery);
  if (why) emit failed(*why);
}

}  // namespace glissade
