#include "engine/evidence/drawn_nut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/evidence/nut_size.h"
#include "engine/model/designation.h"

namespace glissade::evidence {
namespace {

/// A hole is as wide as its shaft up to this difference, in radii.
constexpr double kEqualHole = 0.02;
/// A body that reaches farther from the axis, in radii of the hole, is no nut.
constexpr double kFarthestOfNut = 3.0;
constexpr int kSupports = 72;
constexpr double kSameWidth = 0.02;
constexpr int kHexagon = 6;

/// Distances from the axis to the planes that touch the body from outside, in even directions about the axis.
using Supports = std::array<double, kSupports>;

/// Twice the distance of the flats of a regular hexagon about the axis; nothing if the body is none.
std::optional<double> hexagonWidth(const Supports& supports) {
  constexpr int kStep = kSupports / kHexagon;
  const auto least = std::min_element(supports.begin(), supports.end());
  const auto from = static_cast<int>(least - supports.begin());
  const double corner = *least / std::cos(std::numbers::pi / kHexagon);
  for (int side = 0; side < kHexagon; ++side) {
    const auto at = [&](int beside) {
      return supports[static_cast<std::size_t>((from + side * kStep + beside) % kSupports)];
    };
    const bool isSide = std::abs(at(0) - *least) <= kSameWidth * *least;
    if (!isSide || std::abs(at(kStep / 2) - corner) > 2.0 * kSameWidth * corner) return std::nullopt;
  }
  return 2.0 * *least;
}

/// The shape about the hole; nothing if the body is farther from the axis than nuts are.
std::optional<NutShape> nutShapeOf(const PlacedBody& body, const CommonThread& cylinders, double hole) {
  const Vector3 u = cylinders.axis.unitOrthogonal();
  const Vector3 v = cylinders.axis.cross(u);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  Supports supports{};
  for (const Vector3& vertex : body.mesh.vertices) {
    const Vector3 from = vertex - cylinders.point;
    const double along = from.dot(cylinders.axis);
    if ((from - along * cylinders.axis).norm() > kFarthestOfNut * hole) return std::nullopt;
    low = std::min(low, along);
    high = std::max(high, along);
    for (int i = 0; i < kSupports; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSupports;
      double& support = supports[static_cast<std::size_t>(i)];
      support = std::max(support, from.dot(std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  const std::optional<double> width = hexagonWidth(supports);
  return NutShape{width ? kHexagon : 0, width.value_or(0.0), high - low, hole};
}

/// False for round parts without a thread.
bool mayBeInNut(StandardPart shaft) {
  constexpr std::array kSmooth{StandardPart::Pin, StandardPart::Bearing, StandardPart::Washer, StandardPart::Ring,
                               StandardPart::Seal};
  return std::find(kSmooth.begin(), kSmooth.end(), shaft) == kSmooth.end();
}

double saidDiameter(const std::optional<Designation>& said, StandardPart part) {
  return said && said->part == part ? said->diameter : 0.0;
}

}  // namespace

bool isNutOnShaft(const CommonThread& cylinders, const LeavingPair& pair) {
  if (std::abs(cylinders.depth) > kEqualHole * cylinders.radius) return false;
  const PlacedBody& nut = cylinders.movingIsShaft ? pair.other : pair.moving;
  const auto shape = nutShapeOf(nut, cylinders, cylinders.radius - cylinders.depth);
  if (!shape) return false;
  const auto ofNut = designationIn(cylinders.movingIsShaft ? pair.nameOfOther : pair.nameOfMoving);
  const auto ofShaft = designationIn(cylinders.movingIsShaft ? pair.nameOfMoving : pair.nameOfOther);
  if (ofShaft && !mayBeInNut(ofShaft->part)) return false;
  const std::vector<ThreadSize> byShape = nutSizes(*shape);
  const bool isNamed = ofNut && ofNut->part == StandardPart::Nut;
  if (!isNamed && byShape.empty()) return false;
  const std::vector<ThreadSize> sizes = sizesOf(saidDiameter(ofNut, StandardPart::Nut), byShape);
  const std::vector<ThreadSize> shaft =
      sizesOf(saidDiameter(ofShaft, StandardPart::Screw), shaftSizes(cylinders.radius));
  return sizes.empty() || shaft.empty() || haveOneSize(sizes, shaft);
}

}  // namespace glissade::evidence
