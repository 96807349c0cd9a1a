#include "engine/product/common_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/product/region_pair.h"

namespace glissade {
namespace {

constexpr double kMostDifference = 0.2;

SurfaceRegions regionsInWorld(const ContactBody& body) {
  return transformed(findSurfaceRegions(welded(*body.mesh)), body.X_WB);
}

}  // namespace

std::optional<ContactAxis> commonAxisOf(const ContactBody& a, const ContactBody& b) {
  const SurfaceRegions regionsA = regionsInWorld(a);
  const SurfaceRegions regionsB = regionsInWorld(b);
  std::optional<ContactAxis> axis;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < regionsA.cylinders.size(); ++i) {
    for (std::uint32_t k = 0; k < regionsB.cylinders.size(); ++k) {
      const auto pair =
          compareRegions(regionsA, {SurfaceRegions::Kind::Cylinder, i}, regionsB, {SurfaceRegions::Kind::Cylinder, k});
      if (!pair || pair->kind != RegionPair::Kind::Coaxial) continue;
      const double difference = std::abs(pair->gap);
      const double most = kMostDifference * std::max(pair->axis->radiusA, pair->axis->radiusB);
      if (difference > most || difference >= least) continue;
      least = difference;
      axis = pair->axis;
    }
  }
  return axis;
}

}  // namespace glissade
