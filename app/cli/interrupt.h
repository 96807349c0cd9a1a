#pragma once

#include <signal.h>

#include <atomic>
#include <thread>

#include "engine/base/stop_token.h"

namespace glissade::cli {

/// Turns SIGINT and SIGTERM into a request to stop. It must be created on the main thread before any other thread. Its
/// own thread waits for the signals, so no signal handler touches data of the program.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  StopToken token() const { return source_.token(); }
  bool requested() const { return token().stopRequested(); }

 private:
  void wait();

  StopSource source_;
  sigset_t signals_;
  sigset_t previousMask_;
  std::atomic<bool> done_{false};
  std::thread waiter_;
};

}  // namespace glissade::cli
