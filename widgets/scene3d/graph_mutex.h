#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace glissade {

/// Held by whoever changes the scene graph or draws it: for one edit, one picture. It is given in the order in which it
/// is asked for, so that two threads that draw again and again take turns: with std::recursive_mutex the one that has
/// it takes it again before the other one wakes up. A thread that has it may lock it again. Meets the standard's
/// BasicLockable.
class GraphMutex {
 public:
  void lock();
  void unlock();

 private:
  std::mutex mutex_;
  std::condition_variable released_;
  std::thread::id owner_;  ///< none: it is free, or about to be taken by whoever is served
  int depth_ = 0;          ///< of the owner's locks
  std::uint64_t nextTurn_ = 0;
  std::uint64_t served_ = 0;  ///< whose turn it is
};

}  // namespace glissade
