#include "engine/operator/head/opentrack_protocol.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace glissade {
namespace {

constexpr double kFarthest = 10.0;                     ///< largest distance, metres
constexpr double kMostTurn = 2.0 * std::numbers::pi;   ///< largest turn, radians
constexpr double kMetres = 0.01;                       ///< metres per centimetre
constexpr double kRadians = std::numbers::pi / 180.0;  ///< radians per degree

}  // namespace

std::optional<HeadReading> parseOpentrack(std::span<const std::byte> datagram) {
  HeadReading reading;
  static_assert(sizeof(reading) == kOpentrackBytes);
  if (datagram.size() != kOpentrackBytes) return std::nullopt;
  std::memcpy(reading.data(), datagram.data(), kOpentrackBytes);
  for (std::size_t i = 0; i < reading.size(); ++i) {
    const bool isLength = i < 3;
    reading[i] *= isLength ? kMetres : kRadians;
    // The comparison also refuses values that are not a number.
    if (!(std::abs(reading[i]) <= (isLength ? kFarthest : kMostTurn))) return std::nullopt;
  }
  return reading;
}

}  // namespace glissade
