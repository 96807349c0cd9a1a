#include "app/cli/interrupt.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace glissade::cli {

Interrupt::Interrupt() : signals_{}, previousMask_{} {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &previousMask_);
  waiter_ = std::thread([this] { wait(); });
}

Interrupt::~Interrupt() {
  done_ = true;
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &previousMask_, nullptr);
}

void Interrupt::wait() {
  const timespec patience{0, 20'000'000};
  while (!done_) {
    if (sigtimedwait(&signals_, nullptr, &patience) > 0) source_.requestStop();
  }
}

StopToken withTimeLimit(const StopToken& stop, double seconds) {
  constexpr double kLongest = 1e9;
  if (seconds <= 0.0) return stop;
  const std::chrono::duration<double> limit(std::min(seconds, kLongest));
  return stop.withDeadline(StopToken::Clock::now() + std::chrono::duration_cast<StopToken::Clock::duration>(limit));
}

}  // namespace glissade::cli
