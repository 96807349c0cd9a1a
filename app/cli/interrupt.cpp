#include "app/cli/interrupt.h"

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

}  // namespace glissade::cli
