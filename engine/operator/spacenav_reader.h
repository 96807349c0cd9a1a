#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/base/diagnostic.h"
#include "engine/operator/hand_inputs.h"

namespace glissade {

/// Reads a 3Dconnexion mouse through the spacenavd daemon (libspnav) on a thread of its own, into the
/// 6D mouse of `hand`. The daemon may be absent, die, fall silent, flood or send garbage: the reader
/// reconnects with back-off, and neither the operator thread nor the window ever waits for it. An exception becomes
/// problem(), and the reader connects again.
/// libspnav holds one connection per process: make at most one of these at a time.
class SpacenavReader {
 public:
  /// A missing daemon is searched for again after `firstBackOff`, then after twice as long each time, up to 4 s.
  explicit SpacenavReader(HandInputsPtr hand, std::chrono::milliseconds firstBackOff = std::chrono::milliseconds(250));
  ~SpacenavReader();
  SpacenavReader(const SpacenavReader&) = delete;
  SpacenavReader& operator=(const SpacenavReader&) = delete;

  /// The exception that last ended the connection; nothing once the daemon is connected again.
  std::optional<Diagnostic> problem() const;
  /// Number of times that the thread has woken up.
  std::uint64_t wakeUps() const;

  struct Connection;

 private:
  std::shared_ptr<Connection> connection_;
};

}  // namespace glissade
