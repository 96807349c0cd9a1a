#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace glissade::spacenav {

/// A packet of the daemon after the handshake (spacenavd 1.1, protocol 1; older versions send the first three kinds
/// only).
using Packet = std::array<std::int32_t, 8>;

enum class PacketKind {
  Event,       ///< an event for libspnav: motion, buttons
  DeviceList,  ///< a mouse was plugged in or pulled out
  Name,        ///< a part of the answer to nameRequest()
  Other,       ///< an unexpected answer, or an event of no interest
  Garbage      ///< the stream is invalid from here on
};
PacketKind kindOf(const Packet& packet);

/// The request for the name of the mouse.
Packet nameRequest();

/// Assembles the name from its packets.
class NameAssembler {
 public:
  /// The name once it is complete; empty where the daemon has no mouse.
  std::optional<std::string> add(const Packet& packet);

 private:
  std::string name_;
};

}  // namespace glissade::spacenav
