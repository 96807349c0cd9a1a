#include "engine/operator/input_mailbox.h"

namespace glissade {

void InputMailbox::connect(const std::string& name) {
  heard_.change([&](Heard& heard) {
    heard.reading.connected = true;
    heard.reading.name = name;
    return true;
  });
}

void InputMailbox::disconnect() {
  heard_.change([](Heard& heard) {
    if (!heard.reading.connected) return false;
    heard.reading.connected = false;
    heard.reading.name.clear();
    heard.reading.axes = RawAxes{};
    return true;
  });
}

void InputMailbox::setAxes(const RawAxes& axes) {
  heard_.change([&](Heard& heard) {
    heard.reading.axes = axes;
    heard.axesAt = Clock::now();
    return true;
  });
}

void InputMailbox::press(std::size_t button) {
  if (button >= kInputButtons) return;
  heard_.change([&](Heard& heard) {
    ++heard.reading.presses[button];
    return true;
  });
}

InputReading InputMailbox::reading() const {
  Heard now = heard_.get();
  const bool silent = silence_ && Clock::now() - now.axesAt > *silence_;
  if (silent || !now.reading.connected) now.reading.axes = RawAxes{};
  return now.reading;
}

}  // namespace glissade
