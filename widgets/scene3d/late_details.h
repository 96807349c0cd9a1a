#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/stop_token.h"
#include "widgets/scene3d/shape_detail.h"

namespace glissade {

class DetailWorker;

/// The coarser arrays of one shape. They are made on a worker when they are first asked for, so that a body can be
/// drawn before; pictures in full detail never ask. get() is called by whoever draws, one at a time.
class LateDetails : public std::enable_shared_from_this<LateDetails> {
 public:
  LateDetails(ShapeDetail finest, std::shared_ptr<DetailWorker> worker);
  /// Null until they are made.
  const std::vector<ShapeDetail>* get();

 private:
  friend class DetailWorker;
  void make(const StopToken& stop);

  ShapeDetail finest_;
  std::shared_ptr<DetailWorker> worker_;  ///< null: they have been asked for
  std::vector<ShapeDetail> details_;      ///< written before isMade_
  std::atomic<bool> isMade_{false};
};

/// Makes coarser arrays, one shape after the other. Those that nobody holds any more are left out. The destructor ends
/// it without making the rest.
class DetailWorker {
 public:
  DetailWorker() = default;
  ~DetailWorker();
  DetailWorker(const DetailWorker&) = delete;
  DetailWorker& operator=(const DetailWorker&) = delete;

  void add(const std::shared_ptr<LateDetails>& details);

 private:
  void run();
  std::shared_ptr<LateDetails> next();

  StopSource stop_;
  std::mutex mutex_;
  std::condition_variable added_;
  std::deque<std::weak_ptr<LateDetails>> waiting_;
  std::thread thread_;  ///< begins with the first shape
};

}  // namespace glissade
