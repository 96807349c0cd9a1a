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

/// The size of a shaft of this outer diameter (metres): the nearest metric one, or the unified one that is drawn with
/// this diameter if the metric one is not.
const ThreadSize& usualThreadSize(double diameter);

/// The pitches of metric threads of an outer diameter: those of its size, within 4 %, and the fine pitches of ISO 261
/// for large diameters, if the diameter is a nominal one within 0.1 mm. Metres; the largest first.
std::vector<double> metricPitches(double diameter);

/// The pitch of the standard thread of 60 degrees of an outer diameter whose core is this much thinner, as a difference
/// of radii: from a hole of the tap drill to the core of the shaft. Metric threads count before unified ones, and
/// coarse ones before fine ones; 0: there is none. Metres.
double pitchOfCore(double diameter, double depth);

/// True if the depth (as in pitchOfCore()) is, within 1 %, that of a thread of this pitch by ISO 68-1: of the core of
/// the nut or of the bolt. A hole of the tap drill is less deep, and has a diameter that other holes have, too.
bool isCoreByStandard(double pitch, double depth);

/// True if it is the coarse pitch of the metric or unified size of this outer diameter, within 2 %. Metres.
bool isCoarsePitch(double diameter, double pitch);

}  // namespace glissade
