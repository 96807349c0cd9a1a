#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace glissade {

/// A tracker's reading of a head: x, y and z in metres, then yaw, pitch and roll in radians, with the tracker's own
/// signs.
using HeadReading = std::array<double, 6>;

/// Bytes of a datagram of OpenTrack's output "UDP over network": six doubles, no header.
inline constexpr std::size_t kOpentrackBytes = 48;
/// The default port of OpenTrack.
inline constexpr int kOpentrackPort = 4242;

/// Reads six doubles in host byte order, x y z in centimetres, yaw pitch roll in degrees. Nothing where the size is
/// wrong, a number is not finite, or the values are impossible: beyond 10 m, or a turn of more than a whole turn.
std::optional<HeadReading> parseOpentrack(std::span<const std::byte> datagram);

}  // namespace glissade
