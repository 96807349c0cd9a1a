#include "widgets/scene3d/late_details.h"

#include <utility>

namespace glissade {

LateDetails::LateDetails(ShapeDetail finest, std::shared_ptr<DetailWorker> worker)
    : finest_(std::move(finest)), worker_(std::move(worker)) {}

const std::vector<ShapeDetail>* LateDetails::get() {
  if (worker_) std::exchange(worker_, nullptr)->add(shared_from_this());
  return isMade_.load(std::memory_order_acquire) ? &details_ : nullptr;
}

void LateDetails::make(const StopToken& stop) {
  details_ = coarserDetails(finest_, stop);
  isMade_.store(true, std::memory_order_release);
}

DetailWorker::~DetailWorker() {
  {
    const std::lock_guard lock(mutex_);
    stop_.requestStop();
  }
  added_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void DetailWorker::add(const std::shared_ptr<LateDetails>& details) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(details);
  }
  added_.notify_one();
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
}

void DetailWorker::run() {
  const StopToken stop = stop_.token();
  while (const std::shared_ptr<LateDetails> details = next()) {
    details->make(stop);
  }
}

/// Waits for the next shape; null at the end.
std::shared_ptr<LateDetails> DetailWorker::next() {
  std::unique_lock lock(mutex_);
  while (!stop_.token().stopRequested()) {
    if (waiting_.empty()) {
      added_.wait(lock);
      continue;
    }
    std::shared_ptr<LateDetails> details = waiting_.front().lock();
    waiting_.pop_front();
    if (details) return details;
  }
  return nullptr;
}

}  // namespace glissade
