#include "engine/operator/input_mailbox.h"

namespace glissade {

void InputMailbox::connect(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    reading_.connected = true;
    reading_.name = name;
  }
  tell();
}

void InputMailbox::disconnect() {
  {
    const std::lock_guard lock(mutex_);
    if (!reading_.connected) return;
    reading_.connected = false;
    reading_.name.clear();
    reading_.axes = RawAxes{};
  }
  tell();
}

void InputMailbox::setAxes(const RawAxes& axes) {
  {
    const std::lock_guard lock(mutex_);
    reading_.axes = axes;
    heard_ = Clock::now();
  }
  tell();
}

void InputMailbox::press(std::size_t button) {
  if (button >= kInputButtons) return;
  {
    const std::lock_guard lock(mutex_);
    ++reading_.presses[button];
  }
  tell();
}

InputReading InputMailbox::reading() const {
  const std::lock_guard lock(mutex_);
  InputReading now = reading_;
  const bool silent = silence_ && Clock::now() - heard_ > *silence_;
  if (silent || !now.connected) now.axes = RawAxes{};
  return now;
}

void InputMailbox::setListener(std::function<void()> listener) {
  const std::lock_guard lock(listenerMutex_);
  listener_ = std::move(listener);
}

void InputMailbox::tell() {
  const std::lock_guard lock(listenerMutex_);
  if (listener_) listener_();
}

}  // namespace glissade
