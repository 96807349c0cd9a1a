#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "engine/collision/motion_bound.h"
#include "engine/collision/world_geometry.h"

namespace glissade {

/// What queries of a world need.
struct QueryGeometry {
  WorldGeometry geometry;
  std::shared_ptr<const MotionBound> motionBound;
};

/// The same, prepared when it is asked for. Any number of threads may ask: the first one prepares, the others wait.
class LaterGeometry {
 public:
  explicit LaterGeometry(std::function<QueryGeometry()> prepare) : prepare_(std::move(prepare)) {}

  /// After an exception (no memory) the next call prepares again.
  const QueryGeometry& get() const {
    std::call_once(once_, [this] {
      prepared_ = prepare_();
      prepare_ = nullptr;
      isPrepared_ = true;
    });
    return prepared_;
  }
  bool isPrepared() const { return isPrepared_; }

 private:
  mutable std::once_flag once_;
  mutable std::function<QueryGeometry()> prepare_;
  mutable QueryGeometry prepared_;
  mutable std::atomic<bool> isPrepared_{false};
};

}  // namespace glissade
