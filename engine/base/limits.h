#pragma once

#include <cmath>
#include <cstddef>

/// The largest and smallest numbers that are accepted from files, the command line and the window, with their reason.
/// Values beyond them are refused where they enter, with file, location, limit and advice.
namespace glissade::limits {

/// Metres; of a coordinate's magnitude, and of a size. Neighbouring doubles are 1.2e-7 m apart there. The collision
/// kernel squares differences of coordinates in single precision, whose largest number is 3.4e38: coordinates from
/// 1e19 m overflow it.
inline constexpr double kLargestLength = 1e9;

/// Metres; of a size. Its square is a normal number in single precision.
inline constexpr double kSmallestSize = 1e-12;

/// The diagonal of the workspace over the object's radius. The shortest growth step is 1e-4 radii, so that the samples
/// of an edge can be counted in a double (2^53 is 9e15).
inline constexpr double kLargestRatio = 1e10;

/// Rigid bodies of a scenario, and entries of each list in it that a person or a program writes one by one. A sphere
/// has 1280 triangles: so many spheres take 0.6 GB.
inline constexpr std::size_t kMostBodies = 20'000;

/// Bytes of a scenario, also of one that was not saved, and of an assembly plan. A plan of a thousand parts has some
/// megabytes.
inline constexpr std::size_t kMostScenarioBytes = 256U << 20;

inline bool isCoordinate(double value) { return std::abs(value) <= kLargestLength; }  // false for NaN
inline bool isSize(double value) { return value >= kSmallestSize && value <= kLargestLength; }

}  // namespace glissade::limits
