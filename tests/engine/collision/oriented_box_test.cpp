#include "engine/collision/kernel/oriented_box.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"
#include "tests/engine/support/mesh_triangles.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

OrientedBox fitted(const std::vector<Triangle>& triangles) {
  std::vector<const Triangle*> all;
  for (const Triangle& triangle : triangles) all.push_back(&triangle);
  return fitBox(all);
}

/// Largest distance of a corner outside the box.
double excess(const OrientedBox& box, const std::vector<Triangle>& triangles) {
  double most = 0.0;
  for (const Triangle& triangle : triangles) {
    for (const Vector3& corner : triangle) {
      most = std::max(most, ((box.axes.transpose() * (corner - box.centre)).cwiseAbs() - box.half).maxCoeff());
    }
  }
  return most;
}

TEST(OrientedBox, ATurnedBoxFitsItself) {
  RandomStream stream(1, "boxes");
  for (int i = 0; i < 100; ++i) {
    const Vector3 size(stream.uniform() + 0.1, stream.uniform() + 0.1, stream.uniform() + 0.1);
    const auto triangles = trianglesOf(transformed(makeBox(size), randomPose(stream, 2.0)));
    const OrientedBox box = fitted(triangles);
    EXPECT_LE(excess(box, triangles), 1e-12);
    EXPECT_NEAR(box.half.prod(), size.prod() / 8.0, 1e-9);
  }
}

TEST(OrientedBox, HoldsEveryCornerAndIsNoLargerThanAlongTheCoordinateAxes) {
  RandomStream stream(2, "crowds");
  for (const int count : {1, 2, 5, 14, 15, 40, 300}) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
      const Pose place = randomPose(stream, 1.0);
      triangles.push_back({place.position, place * Vector3(0.2, 0, 0), place * Vector3(0, stream.uniform(), 0)});
    }
    Box3 along;
    for (const Triangle& triangle : triangles) {
      for (const Vector3& corner : triangle) along.extend(corner);
    }
    const OrientedBox box = fitted(triangles);
    EXPECT_LE(excess(box, triangles), 1e-12) << count;
    EXPECT_LE(box.surface(), OrientedBox({along.center(), box.axes, 0.5 * along.sizes()}).surface() + 1e-12) << count;
  }
}

}  // namespace
}  // namespace glissade
