#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace glissade {

/// What a tracker says of a head: x, y and z in metres, then yaw, pitch and roll in radians, by the tracker's own
/// signs.
using HeadReading = std::array<double, 6>;

/// Bytes of a datagram of OpenTrack's output "UDP over network": six doubles, no header.
inline constexpr std::size_t kOpentrackBytes = 48;
/// The port that OpenTrack sends to unless it is set.
inline constexpr int kOpentrackPort = 4242;

/// Six doubles in host byte order, x y z in centimetres, yaw pitch roll in degrees. Nothing where the size is another
/// one, a number is not finite, or nobody's head is there: beyond 10 m, or turned by more than a whole turn.
std::optional<HeadReading> parseOpentrack(std::span<const std::byte> datagram);

}  // namespace glissade
