#pragma once

#include <string>
#include <vector>

namespace glissade {

/// The family of a thread's size.
enum class ThreadFamily {
  Metric,      ///< ISO 261
  Unified,     ///< ASME B1.1: UNC and UNF
  Tapping,     ///< ISO 1478: screws that cut their threads in sheet metal
  Wood,        ///< DIN 7998
  Pipe,        ///< ISO 228
  Trapezoidal  ///< ISO 2904
};

/// A standard size of a thread; metres.
struct ThreadSize {
  ThreadFamily family = ThreadFamily::Metric;
  std::string name;                   ///< for example "M10", "#10", "1/4", "ST4.2"
  double diameter = 0.0;              ///< outer diameter of the thread
  double pitch = 0.0;                 ///< coarse pitch; 0: it has none
  std::vector<double> finePitches{};  ///< the largest first
  double acrossFlats = 0.0;  ///< width across flats of its nut: ISO 4032, ASME B18.2.2 and B18.6.3; 0: it has none

  /// The default pitch: coarse, else fine.
  double usualPitch() const { return pitch > 0.0 || finePitches.empty() ? pitch : finePitches.front(); }
};

/// The sizes of a family, the smallest first.
const std::vector<ThreadSize>& threadSizes(ThreadFamily family);

/// The size of the family that is nearest to a diameter (metres).
const ThreadSize& nearestThreadSize(ThreadFamily family, double diameter);

}  // namespace glissade
