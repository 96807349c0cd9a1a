#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/base/diagnostic.h"
#include "engine/base/work_watch.h"

namespace glissade {

/// Does one thing at a time in a thread of its own, or at once where time is not real. start() and cancel() ask the
/// work under way to stop and forget it, without waiting; the destructor waits.
class BackgroundTask final : public QObject {
  Q_OBJECT

 public:
  /// Hands over what the work found; called on this object's thread.
  using Delivery = std::function<void()>;
  /// The work, which runs on another thread. It holds copies of its input.
  using Work = std::function<Delivery(const WorkWatch&)>;

  explicit BackgroundTask(QObject* parent = nullptr);
  ~BackgroundTask() override;

  /// `doing` names the work in the diagnostic of an exception, for example "reading the parts". `atOnce`: the result is
  /// delivered before this function returns.
  void start(const Message& doing, const Work& work, bool atOnce);
  void cancel();
  bool isBusy() const { return busy_; }

 signals:
  void started();
  /// Emitted a few times a second; `share` is in [0, 1].
  void progressed(double share);
  /// The result was delivered, or the work failed or was cancelled.
  void ended();
  /// Emitted after ended(): an exception has left the work or its delivery, or no thread could be started.
  void failed(const glissade::Diagnostic& why);

 private:
  struct Found {
    Delivery delivery;
    std::optional<Diagnostic> problem;  ///< an exception has left the work: nothing is delivered
  };
  struct Worker {
    std::uint64_t request = 0;
    Message doing;
    std::thread thread;
    Found found;  ///< belongs to the thread until `done`
    std::atomic<bool> done{false};
  };

  void startWorker(const Message& doing, const Work& work);
  void announceEnd();
  void collect();
  void deliver(const Message& doing, const Found& found);
  void end();

  std::list<Worker> workers_;
  StopSource stop_;
  std::shared_ptr<std::atomic<double>> share_;
  std::uint64_t request_ = 0;
  bool busy_ = false;
  QTimer look_;
};

}  // namespace glissade
