#include "engine/evidence/nut_size.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade::evidence {
namespace {

constexpr std::array kNutFamilies{ThreadFamily::Metric, ThreadFamily::Unified};

/// Limits of the ratio of the width to that of ISO 4032: small nuts of JIS B 1181, nuts of DIN 934, flange nuts, heavy
/// nuts.
constexpr double kLeastWidth = 0.87;
constexpr double kMostWidth = 1.15;
/// Limits of the ratio of the height to the diameter: thin nuts of ISO 4035 to high ones of DIN 6334.
constexpr double kLeastHeight = 0.3;
constexpr double kMostHeight = 3.1;
/// Largest ratio of the hole to the outer diameter of the thread; the least one is given by the core.
constexpr double kMostHole = 1.06;
/// Limits of the difference between thread and core, in pitches.
constexpr double kDeepestCore = 1.3;
constexpr double kLeastCore = 0.9;
/// Limits of the ratio of a shaft's diameter to its nominal diameter.
constexpr double kLeastNominal = 0.96;
constexpr double kMostNominal = 1.02;
/// Relative difference within which diameters of names are equal.
constexpr double kNearDiameter = 0.03;

bool isNutOf(const ThreadSize& size, const NutShape& nut) {
  const double hole = 2.0 * nut.hole;
  return nut.width >= kLeastWidth * size.acrossFlats && nut.width <= kMostWidth * size.acrossFlats &&
         nut.height >= kLeastHeight * size.diameter && nut.height <= kMostHeight * size.diameter &&
         hole >= size.diameter - kDeepestCore * size.usualPitch() && hole <= kMostHole * size.diameter;
}

}  // namespace

std::vector<ThreadSize> nutSizes(const NutShape& nut) {
  std::vector<ThreadSize> sizes;
  if (nut.sides == 0) return sizes;
  for (const ThreadFamily family : kNutFamilies) {
    for (const ThreadSize& size : threadSizes(family)) {
      if (size.acrossFlats > 0.0 && isNutOf(size, nut)) sizes.push_back(size);
    }
  }
  return sizes;
}

std::vector<ThreadSize> shaftSizes(double radius) {
  std::vector<ThreadSize> nominal;
  std::vector<ThreadSize> byCore;
  for (const ThreadFamily family : kNutFamilies) {
    for (const ThreadSize& size : threadSizes(family)) {
      const double share = 2.0 * radius / size.diameter;
      const double inPitches = (size.diameter - 2.0 * radius) / size.usualPitch();
      if (share >= kLeastNominal && share <= kMostNominal) nominal.push_back(size);
      if (inPitches >= kLeastCore && inPitches <= kDeepestCore) byCore.push_back(size);
    }
  }
  return nominal.empty() ? byCore : nominal;
}

std::vector<ThreadSize> sizesOf(double said, std::vector<ThreadSize> byShape) {
  if (!(said > 0.0)) return byShape;
  std::vector<ThreadSize> sizes;
  for (const ThreadFamily family : kNutFamilies) {
    const ThreadSize& nearest = nearestThreadSize(family, said);
    if (std::abs(nearest.diameter - said) <= kNearDiameter * said) sizes.push_back(nearest);
  }
  return sizes;
}

bool haveOneSize(const std::vector<ThreadSize>& nut, const std::vector<ThreadSize>& shaft) {
  return std::any_of(nut.begin(), nut.end(), [&](const ThreadSize& one) {
    return std::any_of(shaft.begin(), shaft.end(), [&](const ThreadSize& other) { return one.name == other.name; });
  });
}

}  // namespace glissade::evidence
