#include "engine/fits/drive_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glissade {
namespace {

constexpr double kDirectionStep = 2.0 * std::numbers::pi / kAxialAngles;
/// Relative spread within which the distances of flats are equal.
constexpr double kFlatSpread = 0.02;
/// Largest share of directions off the flats, for corners that are cut.
constexpr double kCutCorners = 0.2;
/// Number of phases of a prism that are tried between two directions.
constexpr int kPhases = 5;
/// Largest ratio of a slot's width to its length, and to the head.
constexpr double kSlotShare = 0.5;
/// Relative difference of radii one period apart.
constexpr double kPeriodShare = 0.12;
/// Ratios of the largest to the least radius of a cross and of six lobes.
constexpr double kLeastCross = 1.45;
constexpr double kLeastLobes = 1.12;
constexpr double kMostLobes = 1.7;

/// Relative spread and middle of values, without the largest ones.
struct Spread {
  double share = std::numeric_limits<double>::infinity();
  double middle = 0.0;
};

Spread spreadOf(std::vector<double> values, double leftOut) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto last = static_cast<std::size_t>((1.0 - leftOut) * static_cast<double>(values.size() - 1));
  const double middle = values[last / 2];
  return {(values[last] - values.front()) / middle, middle};
}

bool isFinite(const std::vector<double>& radii) {
  return std::all_of(radii.begin(), radii.end(), [](double r) { return std::isfinite(r) && r > 0.0; });
}

/// Distances of the flats of a prism that is turned by the phase. Corners that are cut seem nearer: their distances are
/// turned into larger ones, so that they can be left out.
Spread flatDistances(const std::vector<double>& radii, int sides, double phase) {
  const double side = 2.0 * std::numbers::pi / sides;
  std::vector<double> distances;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = static_cast<double>(i) * kDirectionStep - phase;
    const double within = angle - side * std::round(angle / side);
    distances.push_back(radii[i] * std::cos(within));
  }
  std::vector<double> sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[sorted.size() / 2];
  for (double& distance : sorted) distance = middle + std::abs(distance - middle);
  Spread spread = spreadOf(sorted, kCutCorners);
  spread.middle = middle;
  return spread;
}

/// True if each radius is about equal to the one a period later.
bool hasPeriod(const std::vector<double>& radii, int periods) {
  const std::size_t shift = radii.size() / static_cast<std::size_t>(periods);
  std::size_t alike = 0;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double other = radii[(i + shift) % radii.size()];
    alike += std::abs(radii[i] - other) <= kPeriodShare * std::max(radii[i], other) ? 1U : 0U;
  }
  return static_cast<double>(alike) >= 0.9 * static_cast<double>(radii.size());
}

/// Width between two parallel walls that are open, or far away, along their direction.
std::optional<double> slotWidth(const std::vector<double>& radii, double head) {
  constexpr double kNearEnd = 0.35;  // angle from the slot's direction within which its end is searched, radians
  for (int step = 0; step < kPhases * kAxialAngles / 2; ++step) {
    const double phase = step * kDirectionStep / kPhases;
    std::vector<double> distances;
    double end = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const double across = std::abs(std::sin(static_cast<double>(i) * kDirectionStep - phase));
      if (across < 0.5 * std::sin(kNearEnd)) end = std::min(end, radii[i]);
      if (across > std::sin(kNearEnd)) distances.push_back(radii[i] * across);
    }
    const Spread spread = spreadOf(distances, 0.0);
    if (spread.share > 2.0 * kFlatSpread || !std::isfinite(spread.middle)) continue;
    if (spread.middle <= kSlotShare * head && spread.middle <= kSlotShare * end) return 2.0 * spread.middle;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> acrossFlats(const std::vector<double>& radii, int sides) {
  if (!isFinite(radii)) return std::nullopt;
  const int phases = kPhases * kAxialAngles / sides;
  Spread best;
  for (int step = 0; step < phases; ++step) {
    const Spread spread = flatDistances(radii, sides, step * kDirectionStep / kPhases);
    if (spread.share < best.share) best = spread;
  }
  if (best.share > kFlatSpread) return std::nullopt;
  return 2.0 * best.middle;
}

DriveShape recessShape(const std::vector<double>& radii, double head) {
  if (const auto width = slotWidth(radii, head)) return {DriveKind::Slot, *width};
  if (!isFinite(radii)) return {};
  if (const auto across = acrossFlats(radii, 6)) return {DriveKind::HexSocket, *across};
  if (acrossFlats(radii, 4)) return {};
  const auto [least, most] = std::minmax_element(radii.begin(), radii.end());
  const double ratio = *most / *least;
  if (hasPeriod(radii, 6) && !hasPeriod(radii, 4) && ratio >= kLeastLobes && ratio <= kMostLobes) {
    return {DriveKind::SixLobe, 2.0 * *most};
  }
  if (hasPeriod(radii, 4) && ratio >= kLeastCross) return {DriveKind::Cross, 2.0 * *most};
  return {};
}

}  // namespace glissade
