#include "engine/fits/nut_size.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
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

/// Width of a regular prism; 0: it is none.
double widthOf(const TurnedShape& nut) {
  if (nut.sides == 6) return nut.drive.size;
  double width = 0.0;
  for (const AxialSlab& slab : nut.slabs) {
    if (const auto across = acrossFlats(slab.farthest, nut.sides)) width = std::max(width, *across);
  }
  return width;
}

bool isNutOf(const ThreadSize& size, const TurnedShape& nut, double width) {
  const double hole = 2.0 * nut.hole;
  return width >= kLeastWidth * size.acrossFlats && width <= kMostWidth * size.acrossFlats &&
         nut.length() >= kLeastHeight * size.diameter && nut.length() <= kMostHeight * size.diameter &&
         hole >= size.diameter - kDeepestCore * size.usualPitch() && hole <= kMostHole * size.diameter;
}

}  // namespace

std::vector<ThreadSize> nutSizes(const TurnedShape& nut) {
  std::vector<ThreadSize> sizes;
  if (nut.kind != TurnedKind::Nut || nut.sides == 0) return sizes;
  const double width = widthOf(nut);
  for (const ThreadFamily family : kNutFamilies) {
    for (const ThreadSize& size : threadSizes(family)) {
      if (size.acrossFlats > 0.0 && isNutOf(size, nut, width)) sizes.push_back(size);
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

bool haveOneSize(const std::vector<ThreadSize>& nut, const std::vector<ThreadSize>& shaft) {
  return std::any_of(nut.begin(), nut.end(), [&](const ThreadSize& one) {
    return std::any_of(shaft.begin(), shaft.end(), [&](const ThreadSize& other) { return one.name == other.name; });
  });
}

}  // namespace glissade
