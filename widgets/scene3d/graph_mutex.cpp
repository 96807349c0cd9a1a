#include "widgets/scene3d/graph_mutex.h"

namespace glissade {

void GraphMutex::lock() {
  const std::thread::id self = std::this_thread::get_id();
  std::unique_lock lock(mutex_);
  if (owner_ != self) {
    const std::uint64_t turn = nextTurn_++;
    released_.wait(lock, [this, turn] { return served_ == turn; });
    owner_ = self;
  }
  ++depth_;
}

void GraphMutex::unlock() {
  {
    const std::lock_guard lock(mutex_);
    if (--depth_ > 0) return;
    owner_ = {};
    ++served_;
  }
  released_.notify_all();
}

}  // namespace glissade
