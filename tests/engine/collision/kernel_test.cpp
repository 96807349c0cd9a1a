// Tests of properties that only our own kernel has: exact answers for difficult triangles and far from the origin, and
// the same bits on every instruction set.
#include "engine/collision/kernel/kernel_query.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/collision/fcl_query.h"
#include "engine/geometry/exact_predicates.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/solid_interior.h"
#include "tests/engine/collision/exact_reference.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MeshPtr share(TriangleMesh mesh) { return std::make_shared<const TriangleMesh>(std::move(mesh)); }

RigidBody bodyOf(TriangleMesh mesh, const Pose& X_WB = Pose::identity()) {
  RigidBody body = boxBody("body", Vector3::Ones(), X_WB);
  body.mesh = share(std::move(mesh));
  return body;
}

/// Random triangles; if `nasty`, three in ten are slivers, and some of them segments or points.
TriangleMesh soup(RandomStream& stream, int count, bool nasty) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    Triangle t;
    for (Vector3& corner : t) {
      for (int axis = 0; axis < 3; ++axis) corner[axis] = stream.uniform(-1.0, 1.0);
    }
    const double kind = nasty ? stream.uniform() : 1.0;
    if (kind < 0.3) t[2] = t[0] + 0.5 * (t[1] - t[0]) + 1e-7 * t[2];
    if (kind < 0.1) t[2] = t[1];
    if (kind < 0.03) t[1] = t[2] = t[0];
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), t.begin(), t.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

struct World {
  std::vector<RigidBody> obstacles;
  MeshPtr object;
  Vector3 origin = Vector3::Zero();
};

std::vector<World> worlds() {
  RandomStream stream(1, "worlds");
  Pose far = Pose::translation({1e4, -1e4, 1e4});
  far.orientation = fromRollPitchYaw(0.3, 0.2, 0.1);
  return {{{bodyOf(soup(stream, 60, false))}, share(scaled(soup(stream, 40, false), Vector3::Constant(0.3)))},
          {{bodyOf(soup(stream, 60, true))}, share(scaled(soup(stream, 40, true), Vector3::Constant(0.3)))},
          {{bodyOf(makeBox({1, 2, 0.5})), bodyOf(makeCylinder(0.3, 2.0, 24))}, makeL()},
          {{bodyOf(makeBox({1, 2, 0.5}), far)}, makeL(), far.position},
          {{bodyOf(makeBox({40, 40, 0.001}))}, share(makeCylinder(0.2, 1.0, 16))}};
}

Pose poseIn(const World& world, RandomStream& stream) {
  Pose q = randomPose(stream, 2.0);
  q.position += world.origin;
  return q;
}

TEST(Kernel, EveryInstructionSetGivesTheSameBits) {
  const auto sets = lanes::available();
  for (const World& world : worlds()) {
    const auto geometry = std::make_shared<const KernelGeometry>(world.obstacles, *world.object);
    KernelQuery plain(geometry, *sets.front());
    for (std::size_t i = 1; i < sets.size(); ++i) {
      KernelQuery query(geometry, *sets[i]);
      RandomStream stream(2, "poses");
      for (int k = 0; k < 2000; ++k) {
        const Pose q = poseIn(world, stream);
        const Pose to = poseIn(world, stream);
        ASSERT_EQ(plain.touches(q), query.touches(q)) << sets[i]->name;
        ASSERT_EQ(plain.touchingBody(q), query.touchingBody(q)) << sets[i]->name;
        if (k % 10 == 0) {
          const auto a = plain.checkMotion(q, to, 1e-3, SeekViolation::First, {});
          const auto b = query.checkMotion(q, to, 1e-3, SeekViolation::First, {});
          ASSERT_EQ(a->status, b->status);
          ASSERT_EQ(a->certified, b->certified);
          ASSERT_EQ(a->at, b->at);
          ASSERT_EQ(a->configurations, b->configurations);
        }
        if (plain.touches(q)) continue;
        const NearestObstacle a = plain.nearest(q, kInfinity);
        const NearestObstacle b = query.nearest(q, kInfinity);
        ASSERT_EQ(a.distance, b.distance) << sets[i]->name;
        ASSERT_EQ(a.body, b.body);
        ASSERT_EQ(a.p_WPo, b.p_WPo);
        ASSERT_EQ(a.p_WPn, b.p_WPn);
      }
    }
  }
}

TEST(Kernel, AnAnswerDoesNotDependOnWhatWasAskedBefore) {
  for (const World& world : worlds()) {
    const auto geometry = std::make_shared<const KernelGeometry>(world.obstacles, *world.object);
    KernelQuery warm(geometry);
    RandomStream stream(3, "poses");
    for (int k = 0; k < 300; ++k) {
      const Pose q = poseIn(world, stream);
      if (warm.touches(q)) continue;
      const NearestObstacle a = warm.nearest(q, kInfinity);
      const NearestObstacle b = KernelQuery(geometry).nearest(q, kInfinity);
      ASSERT_EQ(a.distance, b.distance);
      ASSERT_EQ(a.p_WPo, b.p_WPo);
      ASSERT_EQ(a.p_WPn, b.p_WPn);
    }
  }
}

TEST(Kernel, DistancesOfSliversAndPointsAreRightAndNeverTooLong) {
  for (const World& world : worlds()) {
    KernelQuery query(std::make_shared<const KernelGeometry>(world.obstacles, *world.object));
    RandomStream stream(4, "poses");
    int checked = 0;
    for (int k = 0; k < 400; ++k) {
      const Pose q = poseIn(world, stream);
      if (query.touches(q)) continue;
      ++checked;
      const double distance = query.nearest(q, kInfinity).distance;
      double expected = kInfinity;
      for (const RigidBody& body : world.obstacles) {
        const TriangleMesh placed = transformed(*world.object, q);
        const TriangleMesh obstacle = transformed(*body.mesh, body.X_WB);
        for (const auto& [a, b, c] : obstacle.triangles) {
          for (const auto& [d, e, f] : placed.triangles) {
            const Triangle s{obstacle.vertices[a], obstacle.vertices[b], obstacle.vertices[c]};
            const Triangle t{placed.vertices[d], placed.vertices[e], placed.vertices[f]};
            expected = std::min(expected, std::sqrt(triangleDistance(s, t).squared));
          }
        }
      }
      ASSERT_NEAR(distance, expected, 1e-9 * expected + 1e-15);
    }
    EXPECT_GT(checked, 10);
  }
}

TEST(Kernel, AgreesWithExactPredicatesFarFromTheOriginToo) {
  for (const World& world : worlds()) {
    if (world.object->triangles.size() == 40) continue;  // random triangles have no inside
    const auto query = CollisionWorld::build(world.obstacles, world.object)->makeQuery();
    RandomStream stream(7, "poses");
    int bisected = 0;
    for (int k = 0; k < 200; ++k) {
      Pose free = poseIn(world, stream);
      Pose touching = poseIn(world, stream);
      ASSERT_EQ(query->collides(free), reference::collides(world.obstacles, *world.object, free));
      if (query->collides(free) || !query->collides(touching)) continue;
      for (int step = 0; step < 60; ++step) {
        const Pose middle = interpolate(free, touching, 0.5);
        (query->collides(middle) ? touching : free) = middle;
      }
      ASSERT_FALSE(reference::collides(world.obstacles, *world.object, free));
      ASSERT_TRUE(reference::collides(world.obstacles, *world.object, touching));
      ++bisected;
    }
    EXPECT_GT(bisected, 5);
  }
}

/// From 1e19 m squares overflow single precision: the search ended only with the stack.
TEST(Kernel, TheSearchOfAMotionEndsBeyondAllMeasureToo) {
  for (const World& world : worlds()) {
    KernelQuery kernel(std::make_shared<const KernelGeometry>(world.obstacles, *world.object));
    for (const double far : {1e19, 1e30, 1e150, 1e300}) {
      for (const Vector3& to : {Vector3(far, 0, 0), Vector3(-far, far, far)}) {
        const auto check = kernel.checkMotion(Pose::identity(), Pose::translation(to), 1e-3, SeekViolation::First, {});
        ASSERT_TRUE(check.has_value());
        EXPECT_LE(check->configurations, 1000U);
      }
    }
  }
}

TEST(Kernel, AgreesWithFclOnAHundredThousandPoses) {
  int compared = 0;
  for (const World& world : worlds()) {
    if (!world.origin.isZero()) continue;  // FCL rounds differently there
    KernelQuery kernel(std::make_shared<const KernelGeometry>(world.obstacles, *world.object));
    FclSurfaceQuery fcl(makeFclGeometry(world.obstacles, *world.object));
    RandomStream stream(5, "poses");
    for (int k = 0; k < 25000; ++k, ++compared) {
      const Pose q = poseIn(world, stream);
      const bool touches = kernel.touches(q);
      ASSERT_EQ(touches, fcl.touches(q)) << "pose " << k;
      if (touches || k % 10 != 0) continue;
      const double expected = fcl.nearest(q, kInfinity).distance;
      ASSERT_NEAR(kernel.nearest(q, kInfinity).distance, expected, 1e-9 * (1.0 + expected));
    }
  }
  EXPECT_EQ(compared, 100'000);
}

/// A mesh with every face added a second time, reversed and with another first corner.
TriangleMesh withBothSides(const TriangleMesh& mesh) {
  TriangleMesh doubled = mesh;
  for (const auto& [a, b, c] : mesh.triangles) doubled.triangles.push_back({b, a, c});
  return doubled;
}

TEST(Kernel, FacesWithTwoSidesAreOneFace) {
  for (const World& world : worlds()) {
    std::vector<RigidBody> obstacles = world.obstacles;
    for (RigidBody& body : obstacles) body.mesh = share(withBothSides(*body.mesh));
    const auto single = std::make_shared<const KernelGeometry>(world.obstacles, *world.object);
    const auto doubled = std::make_shared<const KernelGeometry>(obstacles, withBothSides(*world.object));
    EXPECT_EQ(doubled->obstacles->triangles.size(), single->obstacles->triangles.size());
    EXPECT_EQ(doubled->object->triangles.size(), single->object->triangles.size());
    KernelQuery one(single);
    KernelQuery two(doubled);
    RandomStream stream(8, "poses");
    for (int k = 0; k < 300; ++k) {
      const Pose q = poseIn(world, stream);
      ASSERT_EQ(one.touchingBody(q), two.touchingBody(q));
      ASSERT_EQ(one.nearest(q, kInfinity).p_WPo, two.nearest(q, kInfinity).p_WPo);
    }
  }
}

TEST(Kernel, TheSameFaceOfTwoBodiesIsTwoFaces) {
  const TriangleMesh box = makeBox({1, 1, 1});
  const KernelGeometry geometry({bodyOf(box), bodyOf(box)}, *makeL());
  EXPECT_EQ(geometry.obstacles->triangles.size(), 2 * box.triangles.size());
}

TEST(TrianglePair, DegenerateAndCoplanarTrianglesMeetWhereTheyDo) {
  const Triangle face{Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
  const auto meets = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    const bool forth = trianglesMeet(face, {a, b, c});
    EXPECT_EQ(forth, trianglesMeet({c, a, b}, face));
    return forth;
  };
  EXPECT_TRUE(meets({1, 1, 0}, {1, 1, 0}, {1, 1, 0}));             // a point on the face
  EXPECT_FALSE(meets({3, 3, 0}, {3, 3, 0}, {3, 3, 0}));            // a point beside it, in its plane
  EXPECT_FALSE(meets({1, 1, 1e-300}, {1, 1, 1}, {1, 1, 0.5}));     // a segment just above
  EXPECT_TRUE(meets({1, 1, -1}, {1, 1, 1}, {1, 1, 0.5}));          // a segment through it
  EXPECT_TRUE(meets({1, 1, 0}, {2, 1, 0}, {1, 2, 0}));             // inside, coplanar
  EXPECT_TRUE(meets({-9, -9, 0}, {99, -9, 0}, {-9, 99, 0}));       // around it, coplanar
  EXPECT_TRUE(meets({4, 0, 0}, {5, 0, 0}, {5, 1, 0}));             // a corner on a corner
  EXPECT_FALSE(meets({4.0 + 1e-15, 0, 0}, {5, 0, 0}, {5, 1, 0}));  // a corner very near to it
  EXPECT_TRUE(meets({2, 2, 0}, {5, 5, 3}, {5, 4, 3}));             // a corner on an edge
}

TEST(ExactPredicates, SignsSurviveCancellation) {
  const Vector3 a(1e4, 1e4, 1e4);
  const Vector3 b = a + Vector3(1, 0, 0);
  const Vector3 c = a + Vector3(0, 1, 0);
  const double ulp = std::nextafter(1e4, 2e4) - 1e4;
  EXPECT_EQ(orientation3d(a, b, c, a + Vector3(0.25, 0.25, 0)), 0);
  EXPECT_EQ(orientation3d(a, b, c, a + Vector3(0.25, 0.25, ulp)), -1);
  EXPECT_EQ(orientation3d(a, b, c, a - Vector3(0.25, 0.25, ulp)), 1);
  EXPECT_EQ(orientation2d(Vector3(0, 0, 0), Vector3(0.1, 0.1, 0), Vector3(0.3, 0.3, 0), 2), 0);
  EXPECT_NE(orientation2d(Vector3(0, 0, 0), Vector3(0.1, 0.1, 0), Vector3(0.3, std::nextafter(0.3, 1.0), 0), 2), 0);
}

TEST(SolidInterior, AgreesWithTheWindingNumberAndTakesRaysThroughEdges) {
  TriangleMesh two = makeCylinder(0.7, 2.0, 24);
  append(two, transformed(makeBox({1, 1, 1}), Pose::translation({0.4, 0, 0})));  // overlapping parts
  const SolidInterior interior(two, true);
  RandomStream stream(6, "points");
  for (int i = 0; i < 5000; ++i) {
    const Vector3 p(stream.uniform(-1.5, 1.5), stream.uniform(-1.5, 1.5), stream.uniform(-1.5, 1.5));
    ASSERT_EQ(interior.contains(p), containsPoint(two, p));
  }
  const SolidInterior box(makeBox({2, 2, 2}), true);
  EXPECT_TRUE(box.contains({0, 0, 0}));  // a ray along the diagonal of a face
  EXPECT_TRUE(box.contains({0.5, 0.5, -0.5}));
  EXPECT_FALSE(box.contains({-5, 1, 1}));
}

}  // namespace
}  // namespace glissade
