#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/base/tolerances.h"
#include "engine/collision/collision_query.h"
#include "engine/planning/path.h"

namespace glissade::test {

/// Some point of the segment is in the closed box, or not farther from it than the margin along any axis: clipped plane
/// by plane (Liang and Barsky 1984), in exact arithmetic.
inline bool meetsBox(const Vector3& from, const Vector3& to, const Box3& box, double margin) {
  using Rational = boost::multiprecision::cpp_rational;
  Rational first = 0;
  Rational last = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational begin(from[axis]);
    const Rational way = Rational(to[axis]) - begin;
    const Rational toMin = Rational(box.min()[axis]) - Rational(margin) - begin;
    const Rational toMax = Rational(box.max()[axis]) + Rational(margin) - begin;
    if (way == 0) {
      if (toMin > 0 || toMax < 0) return false;
      continue;
    }
    const Rational atMin = toMin / way;
    const Rational atMax = toMax / way;
    first = std::max(first, std::min(atMin, atMax));
    last = std::min(last, std::max(atMin, atMax));
  }
  return first <= last;
}

/// The forbidden place that a path meets; empty: it keeps the margin from all.
inline std::string metBy(const std::vector<Pose>& path, const ForbiddenPlaces& places, double margin) {
  for (const ForbiddenPlace& place : places) {
    for (const Box3& box : place.boxes) {
      for (std::size_t i = 0; i < path.size(); ++i) {
        const Vector3& to = path[std::min(i + 1, path.size() - 1)].position;
        if (meetsBox(path[i].position, to, box, margin)) return place.name;
      }
    }
  }
  return {};
}

/// Metres that the object of this world keeps from forbidden places.
inline double forbiddenMarginOf(const CollisionWorld& world) {
  return tolerance::kForbiddenMargin * world.objectRadius();
}

/// A point of a lattice of ninths, so that faces, edges and corners of boxes and ends of segments coincide often. A
/// ninth is no binary number.
inline Vector3 latticePoint(RandomStream& stream, int most) {
  const auto coordinate = [&] { return std::floor(stream.uniform(0.0, most + 1.0)) / 9.0; };
  return {coordinate(), coordinate(), coordinate()};
}

/// A box between points of the lattice; some are flat.
inline Box3 latticeBox(RandomStream& stream, int most) {
  const Vector3 a = latticePoint(stream, most);
  const Vector3 b = latticePoint(stream, most);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

}  // namespace glissade::test
