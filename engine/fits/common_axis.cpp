#include "engine/fits/common_axis.h"

#include <algorithm>
#include <cmath>

#include "engine/fits/region_pair.h"

namespace glissade {
namespace {

constexpr double kMostDifference = 0.2;

SurfaceRegions regionsInWorld(const ContactBody& body) {
  return transformed(findSurfaceRegions(welded(*body.mesh)), body.X_WB);
}

double differenceOf(const ContactAxis& axis) { return std::abs(axis.radiusA - axis.radiusB); }

}  // namespace

std::vector<ContactAxis> commonAxesOf(const ContactBody& a, const ContactBody& b) {
  const SurfaceRegions regionsA = regionsInWorld(a);
  const SurfaceRegions regionsB = regionsInWorld(b);
  std::vector<ContactAxis> axes;
  for (std::uint32_t i = 0; i < regionsA.cylinders.size(); ++i) {
    for (std::uint32_t k = 0; k < regionsB.cylinders.size(); ++k) {
      const auto pair =
          compareRegions(regionsA, {SurfaceRegions::Kind::Cylinder, i}, regionsB, {SurfaceRegions::Kind::Cylinder, k});
      if (!pair || pair->kind != RegionPair::Kind::Coaxial) continue;
      const ContactAxis& axis = *pair->axis;
      if (differenceOf(axis) <= kMostDifference * std::max(axis.radiusA, axis.radiusB)) axes.push_back(axis);
    }
  }
  std::stable_sort(axes.begin(), axes.end(), [](const ContactAxis& one, const ContactAxis& other) {
    return differenceOf(one) < differenceOf(other);
  });
  return axes;
}

std::optional<ContactAxis> commonAxisOf(const ContactBody& a, const ContactBody& b) {
  const std::vector<ContactAxis> axes = commonAxesOf(a, b);
  return axes.empty() ? std::nullopt : std::optional(axes.front());
}

}  // namespace glissade
