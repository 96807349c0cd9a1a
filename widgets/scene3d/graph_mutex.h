#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace glissade {

/// Held while the scene graph is changed or drawn: for one edit, or one picture. Threads get it in the order of their
/// requests, so that two threads that draw repeatedly take turns. With std::recursive_mutex, the thread that holds it
/// could lock it again before the other one wakes up. The owner may lock it again. Meets the standard's BasicLockable.
class GraphMutex {
 public:
  void lock();
  void unlock();

 private:
  std::mutex mutex_;
  std::condition_variable released_;
  std::thread::id owner_;  ///< none: it is free, or about to be taken by the next thread
  int depth_ = 0;          ///< number of the owner's locks
  std::uint64_t nextTurn_ = 0;
  std::uint64_t served_ = 0;  ///< turn of the thread that may hold it now
};

}  // namespace glissade
