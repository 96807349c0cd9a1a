#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/base/mailbox.h"
#include "engine/operator/device_shaping.h"

namespace glissade {

/// Number of buttons that are counted; further buttons of a device are ignored.
inline constexpr std::size_t kInputButtons = 16;

/// Latest state of a device.
struct InputReading {
  bool connected = false;
  std::string name;                                    ///< the device's own name; empty where none is connected
  RawAxes axes{};                                      ///< all 0 after silence and while disconnected
  std::array<std::uint32_t, kInputButtons> presses{};  ///< number of presses of each button since the beginning

  bool atRest() const { return axes == RawAxes{}; }
};

/// Passes data between the reader of a device and its users. The latest axes count; presses are counted so that none is
/// lost. All functions may be called from any thread and return at once.
class InputMailbox {
 public:
  using Clock = std::chrono::steady_clock;

  /// Axes count as released after `silence` without data (a daemon that hangs, a held puck whose events go elsewhere);
  /// nothing: the last state holds, for devices that report changes only.
  explicit InputMailbox(std::optional<std::chrono::milliseconds> silence = {}) : silence_(silence) {}

  void connect(const std::string& name);
  void disconnect();
  void setAxes(const RawAxes& axes);
  void press(std::size_t button);

  InputReading reading() const;

  /// Called after every change, on the thread that made it; must return at once. After
  /// setListener({}) has returned no call is under way. The listener may read and must not write.
  void setListener(std::function<void()> listener) { heard_.setListener(std::move(listener)); }

 private:
  struct Heard {
    InputReading reading;
    Clock::time_point axesAt;
  };

  const std::optional<std::chrono::milliseconds> silence_;
  Mailbox<Heard> heard_;
};

}  // namespace glissade
