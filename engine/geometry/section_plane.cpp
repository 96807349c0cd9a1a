#include "engine/geometry/section_plane.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

Vector3 cornerOf(const Box3& box, unsigned index) {
  Vector3 corner;
  for (int axis = 0; axis < 3; ++axis) corner[axis] = (index >> axis) & 1U ? box.max()[axis] : box.min()[axis];
  return corner;
}

}  // namespace

Plane planeOf(const SectionPlane& section) {
  const double side = section.otherSide ? -1.0 : 1.0;
  return {side * section.direction, side * section.place};
}

PlaceRange rangeAlong(const Vector3& direction, const Box3& box) {
  PlaceRange range{direction.dot(box.min()), direction.dot(box.min())};
  for (unsigned i = 1; i < 8; ++i) {
    const double place = direction.dot(cornerOf(box, i));
    range = {std::min(range.least, place), std::max(range.greatest, place)};
  }
  return range;
}

std::vector<Vector3> outlineInBox(const Plane& plane, const Box3& box) {
  std::vector<Vector3> corners;
  for (unsigned from = 0; from < 8; ++from) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned to = from | (1U << axis);
      if (to == from) continue;
      const Vector3 a = cornerOf(box, from);
      const Vector3 b = cornerOf(box, to);
      const double below = plane.normal.dot(a) - plane.offset;
      const double above = plane.normal.dot(b) - plane.offset;
      if ((below < 0.0) == (above < 0.0)) continue;
      corners.emplace_back(a + below / (below - above) * (b - a));
    }
  }
  if (corners.size() < 3) return {};
  Vector3 middle = Vector3::Zero();
  for (const Vector3& corner : corners) middle += corner / static_cast<double>(corners.size());
  const Vector3 u = plane.normal.unitOrthogonal();
  const Vector3 v = plane.normal.cross(u);
  const auto angle = [&](const Vector3& p) { return std::atan2((p - middle).dot(v), (p - middle).dot(u)); };
  std::sort(corners.begin(), corners.end(), [&](const Vector3& a, const Vector3& b) { return angle(a) < angle(b); });
  return corners;
}

}  // namespace glissade
