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

/// The coarser arrays of one shape. A worker makes them after the first call of get(), so that a body can be drawn
/// before; pictures in full detail never call it. Only one thread at a time may call get().
class LateDetails : public std::enable_shared_from_this<LateDetails> {
 public:
  LateDetails(ShapeDetail finest, std::shared_ptr<DetailWorker> worker);
  /// Null until the arrays are made.
  const std::vector<ShapeDetail>* get();

 private:
  friend class DetailWorker;
  void make(const StopToken& stop);

  ShapeDetail finest_;
  std::shared_ptr<DetailWorker> worker_;  ///< null: the arrays have been requested
  std::vector<ShapeDetail> details_;      ///< written before isMade_ is set
  std::atomic<bool> isMade_{false};
};

/// Makes coarser arrays, one shape after the other. Shapes that nothing refers to any more are left out. The destructor
/// ends the work without making the rest.
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
