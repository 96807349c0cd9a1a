#include "engine/product/nut_size.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

constexpr std::array kNutFamilies{ThreadFamily::Metric, ThreadFamily::Unified};

/// Width by that of ISO 4032: small ones of JIS B 1181, those of DIN 934, of flanges, and heavy ones.
constexpr double kLeastWidth = 0.87;
constexpr double kMostWidth = 1.15;
/// Height by the diameter: from thin nuts of ISO 4035 to high ones of DIN 6334.
constexpr double kLeastHeight = 0.3;
constexpr double kMostHeight = 3.1;
/// The hole is drawn between the core and a little more than the thread outside, by the diameter.
constexpr double kMostHole = 1.06;
/// A core is this many pitches thinner than the thread, at most and at least.
constexpr double kDeepestCore = 1.3;
constexpr double kLeastCore = 0.9;
/// A shaft is drawn with its nominal diameter within these.
constexpr double kLeastNominal = 0.96;
constexpr double kMostNominal = 1.02;

/// Of a regular prism; 0: it is none.
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
