#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/operator/hand_inputs.h"
#include "engine/operator/reader_problem.h"

namespace glissade {

/// Reads a game controller (SDL2) on a thread of its own, into the gamepad of `hand`: the first one that
/// is plugged in, and the next one when it is pulled out.
///
///   left stick  right, up      triggers   left nearer, right away
///   right stick turn, tip      shoulders  roll
///
/// An exception becomes problem(), and the reader looks for a gamepad again.
///
/// SDL keeps its state per process: make at most one of these at a time.
class GamepadReader {
 public:
  explicit GamepadReader(HandInputsPtr hand);
  ~GamepadReader();
  GamepadReader(const GamepadReader&) = delete;
  GamepadReader& operator=(const GamepadReader&) = delete;

  /// The exception that last ended the reading; nothing while a gamepad is read again.
  std::optional<Diagnostic> problem() const { return problem_.get(); }
  /// Number of times that the thread has woken up.
  std::uint64_t wakeUps() const { return wakeUps_; }

 private:
  void run();
  void readPads();
  bool quitWithin(std::chrono::milliseconds patience);

  HandInputsPtr hand_;
  std::atomic<std::uint64_t> wakeUps_{0};
  std::mutex mutex_;
  std::condition_variable quitWanted_;
  bool quit_ = false;
  ReaderProblem problem_;
  std::thread thread_;
};

}  // namespace glissade
