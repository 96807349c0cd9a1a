#include "engine/check/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"
#include "engine/geometry/triangle_tree.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade::check {
namespace {

/// All faces of all prisms, by definition.
TriangleMesh allPrisms(const TriangleMesh& mesh, const Vector3& way) {
  TriangleMesh all;
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const std::uint32_t corner : {i, j, k}) all.vertices.push_back(mesh.vertices[corner]);
    for (const std::uint32_t corner : {i, j, k}) all.vertices.emplace_back(mesh.vertices[corner] + way);
    all.triangles.push_back({first, first + 1, first + 2});
    all.triangles.push_back({first + 3, first + 4, first + 5});
    for (std::uint32_t e = 0; e < 3; ++e) {
      const std::uint32_t a = first + e;
      const std::uint32_t b = first + (e + 1) % 3;
      all.triangles.push_back({a, b, b + 3});
      all.triangles.push_back({a, b + 3, a + 3});
    }
  }
  return all;
}

bool isPassedOver(const TriangleMesh& mesh, const Vector3& way, const Vector3& point) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const TriangleIndices& t) {
    return passesOver(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], way, point);
  });
}

double distanceTo(const TriangleTree& tree, const Vector3& point) {
  return tree.nearest(point, std::numeric_limits<double>::infinity()).distance;
}

/// A random selection of the mesh's triangles, with open edges, edges of three triangles, and corners that only touch.
TriangleMesh torn(const TriangleMesh& mesh, RandomStream& stream) {
  TriangleMesh some = mesh;
  some.triangles.clear();
  for (const TriangleIndices& triangle : mesh.triangles) {
    if (stream.uniform() < 0.7) some.triangles.push_back(triangle);
  }
  some.triangles.push_back({0, 1, static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
  return some;
}

double leastHeight(const TriangleMesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 ab = mesh.vertices[b] - mesh.vertices[a];
    const Vector3 ac = mesh.vertices[c] - mesh.vertices[a];
    least = std::min(least, ab.cross(ac).norm() / std::max(ab.norm(), ac.norm()));
  }
  return least;
}

/// For points that no triangle passes over, the kept boundary is as near as the faces of all prisms. In half of the
/// cases the motion is along faces.
TEST(SweptBy, IsAsNearAsAllPrismsAre) {
  RandomStream stream(11, "sweeps");
  int outside = 0;
  int smaller = 0;
  for (int i = 0; i < 300; ++i) {
    const TriangleMesh whole = i % 3 == 0 ? *makeL() : (i % 3 == 1 ? makeCylinder(0.5, 1.0, 12) : makeSphere(0.7, 1));
    const TriangleMesh straight = i % 5 == 0 ? torn(whole, stream) : whole;
    const TriangleMesh mesh = welded(transformed(straight, randomPose(stream, 1.0)));
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
    const Vector3 way = i % 2 == 0 ? Vector3(mesh.vertices[b] - mesh.vertices[a])
                                   : Vector3(stream.normal(), stream.normal(), stream.normal());
    const TriangleMesh kept = sweptBy(mesh, way);
    const TriangleMesh all = allPrisms(mesh, way);
    ASSERT_GT(leastHeight(kept), 1e-12) << "FCL finds collisions of triangles without area that are none";
    smaller += kept.triangles.size() < all.triangles.size() / 2 ? 1 : 0;
    const TriangleTree keptTree(kept);
    const TriangleTree allTree(all);
    for (int k = 0; k < 40; ++k) {
      const Vector3 point = randomPose(stream, 3.0).position;
      if (isPassedOver(mesh, way, point)) continue;
      ++outside;
      ASSERT_NEAR(distanceTo(keptTree, point), distanceTo(allTree, point), 1e-9) << i << ' ' << k;
    }
  }
  EXPECT_GT(outside, 3000);
  EXPECT_GT(smaller, 150);
}

}  // namespace
}  // namespace glissade::check
