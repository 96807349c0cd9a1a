#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <thread>

#include "engine/base/work_watch.h"

namespace glissade {

/// Does one thing at a time in a thread of its own, or at once where time is not real. start() and
/// cancel() ask what is under way to stop and forget it, without waiting; the end of this object waits.
class BackgroundTask final : public QObject {
  Q_OBJECT

 public:
  /// What is to happen on this object's thread with what was found.
  using Delivery = std::function<void()>;
  /// Runs on another thread: holds values of its own and throws nothing.
  using Work = std::function<Delivery(const WorkWatch&)>;

  explicit BackgroundTask(QObject* parent = nullptr);
  ~BackgroundTask() override;

  /// `atOnce`: delivered before this returns.
  void start(const Work& work, bool atOnce);
  void cancel();
  bool isBusy() const { return busy_; }

 signals:
  void started();
  /// A few times a second, in [0, 1].
  void progressed(double share);
  /// Delivered or cancelled.
  void ended();

 private:
  void deliver(std::uint64_t request, const Delivery& delivery);
  void end();
  void joinFinished();

  struct Worker {
    std::thread thread;
    std::atomic<bool> done{false};
  };
  std::list<Worker> workers_;
  StopSource stop_;
  std::shared_ptr<std::atomic<double>> share_;
  std::uint64_t request_ = 0;
  bool busy_ = false;
  QTimer look_;
};

}  // namespace glissade
