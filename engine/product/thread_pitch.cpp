#include "engine/product/thread_pitch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace glissade {
namespace {

/// Millimetres.
struct CoarseThread {
  double diameter;
  double pitch;
};
constexpr std::array<CoarseThread, 39> kCoarseThreads{
    {{1.0, 0.25}, {1.1, 0.25}, {1.2, 0.25}, {1.4, 0.3}, {1.6, 0.35}, {1.8, 0.35}, {2.0, 0.4}, {2.2, 0.45},
     {2.5, 0.45}, {3.0, 0.5},  {3.5, 0.6},  {4.0, 0.7}, {4.5, 0.75}, {5.0, 0.8},  {6.0, 1.0}, {7.0, 1.0},
     {8.0, 1.25}, {9.0, 1.25}, {10.0, 1.5}, {11., 1.5}, {12., 1.75}, {14., 2.0},  {16., 2.0}, {18., 2.5},
     {20., 2.5},  {22., 2.5},  {24., 3.0},  {27., 3.0}, {30., 3.5},  {33., 3.5},  {36., 4.0}, {39., 4.0},
     {42., 4.5},  {45., 4.5},  {48., 5.0},  {52., 5.0}, {56., 5.5},  {60., 5.5},  {64., 6.0}}};

/// Share of the nominal diameter that one of this size may be off it.
constexpr double kNominalShare = 0.04;

/// Share of the shaft's radius, and of the coarse pitch: what is drawn thicker by less is pressed in.
constexpr double kLeastDepth = 0.02;
constexpr double kLeastDepthInPitches = 0.15;

/// `diameter`: millimetres.
const CoarseThread& nearestTo(double diameter) {
  return *std::min_element(kCoarseThreads.begin(), kCoarseThreads.end(),
                           [&](const CoarseThread& one, const CoarseThread& other) {
                             return std::abs(one.diameter - diameter) < std::abs(other.diameter - diameter);
                           });
}

std::string sizeOf(const CoarseThread& thread) {
  std::ostringstream size;
  size << "M" << thread.diameter;
  return size.str();
}

}  // namespace

ThreadPitch isoCoarsePitch(double radius) {
  const CoarseThread& nearest = nearestTo(2e3 * radius);
  return {1e-3 * nearest.pitch, sizeOf(nearest)};
}

std::string nominalSize(double diameter) {
  const CoarseThread& nearest = nearestTo(1e3 * diameter);
  const bool isNominal = std::abs(1e3 * diameter - nearest.diameter) <= kNominalShare * nearest.diameter;
  return isNominal ? sizeOf(nearest) : std::string();
}

bool isThreadDepth(double radius, double depth) {
  return depth > kLeastDepth * radius && depth > kLeastDepthInPitches * isoCoarsePitch(radius).pitch;
}

}  // namespace glissade
