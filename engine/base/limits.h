#pragma once

#include <cmath>
#include <cstddef>

/// Limits of numbers from files, the command line and the window, with their reasons. Values beyond them are refused
/// when they are read, with file, location, limit and advice.
namespace glissade::limits {

/// Largest magnitude of a coordinate, and largest size, metres. Neighbouring doubles are 1.2e-7 m apart there. The
/// collision kernel squares differences of coordinates in single precision, whose largest number is 3.4e38, so that
/// coordinates from 1e19 m overflow it.
inline constexpr double kLargestLength = 1e9;

/// Smallest size, metres. Its square is a normal number in single precision.
inline constexpr double kSmallestSize = 1e-12;

/// Largest ratio of the workspace's diagonal to the object's radius. The shortest growth step is 1e-4 radii, so that a
/// double counts the samples of an edge exactly (2^53 is 9e15).
inline constexpr double kLargestRatio = 1e10;

/// Most rigid bodies of a scenario, and most entries of each list that a person or a program writes one by one. A
/// sphere has 1280 triangles, so that this number of spheres takes 0.6 GB.
inline constexpr std::size_t kMostBodies = 20'000;

/// Largest size of a scenario, saved or not, and of an assembly plan, bytes. A plan of a thousand parts has some
/// megabytes.
inline constexpr std::size_t kMostScenarioBytes = 256U << 20;

inline bool isCoordinate(double value) { return std::abs(value) <= kLargestLength; }  // false for NaN
inline bool isSize(double value) { return value >= kSmallestSize && value <= kLargestLength; }

}  // namespace glissade::limits
