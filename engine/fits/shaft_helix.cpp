#include "engine/fits/shaft_helix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/evidence/crest_helix.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// Length of the shaft that is measured, in radii: a coarse thread has at least two turns in it.
constexpr double kLookedAt = 1.5;
constexpr std::size_t kFewestSections = 24;
/// Least offset of a thread's section from the axis, in radii.
constexpr double kLeastEccentric = 0.01;
/// Radians: largest turn between two sections, and largest deviation from a uniform turn.
constexpr double kMostTurn = 1.5;
constexpr double kMostResidual = 0.4;
constexpr double kFewestTurns = 0.8;
constexpr double kStandardShare = 0.03;

struct SectionPhase {
  double height = 0.0;
  double phase = 0.0;  ///< direction of the crest, radians, without jumps
};

/// The directions of the crests of a thread of so many starts, times the starts.
std::vector<SectionPhase> phasesOf(const std::vector<AxialSlab>& slabs, double radius, int starts) {
  std::vector<SectionPhase> phases;
  for (const AxialSlab& slab : slabs) {
    double x = 0.0;
    double y = 0.0;
    for (std::size_t i = 0; i < slab.farthest.size(); ++i) {
      const double angle = 2.0 * std::numbers::pi * starts * static_cast<double>(i) / kAxialAngles;
      x += slab.farthest[i] * std::cos(angle);
      y += slab.farthest[i] * std::sin(angle);
    }
    if (2.0 * std::hypot(x, y) / kAxialAngles < kLeastEccentric * radius) return {};
    double phase = std::atan2(y, x);
    if (!phases.empty()) {
      const double turn = std::remainder(phase - phases.back().phase, 2.0 * std::numbers::pi);
      if (std::abs(turn) > kMostTurn) return {};
      phase = phases.back().phase + turn;
    }
    phases.push_back({0.5 * (slab.low + slab.high), phase});
  }
  return phases;
}

/// Turn of the phases in radians a metre, by least squares; 0 if it is not uniform.
double evenTurn(const std::vector<SectionPhase>& phases) {
  double height = 0.0;
  double phase = 0.0;
  for (const SectionPhase& one : phases) {
    height += one.height;
    phase += one.phase;
  }
  const auto count = static_cast<double>(phases.size());
  height /= count;
  phase /= count;
  double product = 0.0;
  double square = 0.0;
  for (const SectionPhase& one : phases) {
    product += (one.height - height) * (one.phase - phase);
    square += (one.height - height) * (one.height - height);
  }
  if (!(square > 0.0)) return 0.0;
  const double slope = product / square;
  for (const SectionPhase& one : phases) {
    if (std::abs(phase + slope * (one.height - height) - one.phase) > kMostResidual) return 0.0;
  }
  return slope;
}

}  // namespace

std::optional<double> modelledPitch(const AxialMesh& screw, const TurnedShape& shape) {
  const double length = shape.headLow - shape.low;
  const double middle = shape.low + 0.4 * length;
  const double half = 0.5 * std::min(kLookedAt * shape.shaft, 0.6 * length);
  const auto slabs = screw.slabsAbout(shape.axis, {middle - half, middle + half, 1.2 * shape.shaft});
  if (slabs.size() < kFewestSections) return std::nullopt;
  for (int starts = 1; starts <= evidence::kMostStarts; ++starts) {
    const auto phases = phasesOf(slabs, shape.shaft, starts);
    if (phases.size() < kFewestSections) continue;
    const double slope = evenTurn(phases);
    if (std::abs(slope) * 2.0 * half < kFewestTurns * 2.0 * std::numbers::pi) continue;
    const double pitch = 2.0 * std::numbers::pi / slope;
    if (std::abs(starts * pitch) > evidence::kMostLead * 2.0 * shape.shaft) continue;
    const double standard = std::copysign(coarsePitch(shape.shaft).pitch, pitch);
    return starts * (std::abs(pitch - standard) < kStandardShare * std::abs(standard) ? standard : pitch);
  }
  return std::nullopt;
}

}  // namespace glissade
