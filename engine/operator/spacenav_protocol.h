#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace glissade::spacenav {

/// Every packet of the daemon after the handshake (spacenavd 1.1, protocol 1; older ones send the first
/// three kinds only).
using Packet = std::array<std::int32_t, 8>;

enum class PacketKind {
  Event,       ///< for libspnav: motion, buttons
  DeviceList,  ///< a mouse was plugged in or pulled out
  Name,        ///< a part of the answer to nameRequest()
  Other,       ///< an answer that nobody waits for, an event of no interest
  Garbage      ///< the stream cannot be trusted any more
};
PacketKind kindOf(const Packet& packet);

/// Asks for the name of the mouse.
Packet nameRequest();

/// Puts the name together from its packets.
class NameAssembler {
 public:
  /// The name once it is whole; empty where the daemon has no mouse.
  std::optional<std::string> add(const Packet& packet);

 private:
  std::string name_;
};

}  // namespace glissade::spacenav
