// Compares worlds whose geometry is shared by occurrences with worlds of the same bodies in one tree.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "engine/collision/collision_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/collision/kernel/occurrence_query.h"
#include "engine/geometry/mesh_audit.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// A closed torus of 2 * around * along triangles.
TriangleMesh makeTorus(double radius, double tube, std::uint32_t around, std::uint32_t along) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double u = 2.0 * std::numbers::pi * i / around;
    for (std::uint32_t k = 0; k < along; ++k) {
      const double v = 2.0 * std::numbers::pi * k / along;
      const double out = radius + tube * std::cos(v);
      mesh.vertices.emplace_back(out * std::cos(u), out * std::sin(u), tube * std::sin(v));
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < along; ++k) {
      const std::uint32_t a = i * along + k;
      const std::uint32_t b = (i + 1) % around * along + k;
      const std::uint32_t c = (i + 1) % around * along + (k + 1) % along;
      const std::uint32_t d = i * along + (k + 1) % along;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// Occurrences of a few meshes at random places, some of which overlap.
std::vector<RigidBody> randomOccurrences(RandomStream& stream, std::size_t count) {
  const std::vector<MeshPtr> meshes{std::make_shared<const TriangleMesh>(makeTorus(0.3, 0.1, 12, 8)),
                                    std::make_shared<const TriangleMesh>(makeBox({0.5, 0.2, 0.3})),
                                    std::make_shared<const TriangleMesh>(makeSphere(0.2))};
  std::vector<RigidBody> bodies;
  for (std::size_t i = 0; i < count; ++i) {
    RigidBody body = boxBody("b" + std::to_string(i), Vector3::Ones(), randomPose(stream, 1.5));
    body.mesh = meshes[i % meshes.size()];
    bodies.push_back(std::move(body));
  }
  return bodies;
}

std::shared_ptr<const OccurrenceGeometry> occurrencesOf(const std::vector<RigidBody>& bodies,
                                                        const TriangleMesh& object) {
  std::vector<OccurrenceGeometry::Occurrence> placed;
  std::vector<Box3> boxes;
  for (const RigidBody& body : bodies) {
    placed.push_back({kernelObstacle(*body.mesh, 1.0), body.X_WB});
    boxes.push_back(boundingBox(*body.mesh, body.X_WB));
  }
  return std::make_shared<const OccurrenceGeometry>(1.0, std::move(placed), boxes, kernelObject(object, 1.0),
                                                    boundingBox(object));
}

TEST(LargeWorld, IsPreparedForItsFirstQueryAndAnswersAsASmallOne) {
  const auto fine = std::make_shared<const TriangleMesh>(makeTorus(0.3, 0.1, 330, 310));
  RigidBody torus = boxBody("torus", Vector3::Ones(), Pose::identity());
  torus.mesh = fine;
  const CollisionWorldPtr obstacleIsLarge = CollisionWorld::build({torus}, makeL());
  const CollisionWorldPtr objectIsLarge =
      CollisionWorld::build({boxBody("box", Vector3::Ones(), Pose::identity())}, fine);
  EXPECT_TRUE(CollisionWorld::build({boxBody("box", Vector3::Ones(), Pose::identity())}, makeL())->isPrepared());
  for (const CollisionWorldPtr& world : {obstacleIsLarge, objectIsLarge}) {
    EXPECT_FALSE(world->isPrepared());
    EXPECT_GT(world->objectRadius(), 0.1);
    EXPECT_FALSE(world->obstaclesBox().isEmpty());
    const CollisionWorldPtr same = world->updated(world->obstacles(), world->obstacles().front().mesh);
    EXPECT_TRUE(world->isPrepared()) << "another world is made of what is prepared";
    EXPECT_TRUE(same->isPrepared());
    const auto query = world->makeQuery();
    EXPECT_TRUE(query->collides(Pose::identity()) || query->nearestObstacle(Pose::identity()).distance > 0.0);
    EXPECT_NEAR(query->motionBound().objectRadius(), world->objectRadius(), 1e-9);
    EXPECT_FALSE(query->collides(Pose::translation({5, 0, 0})));
  }
}

TEST(QueryCounts, PairsTellWhatAnswersCost) {
  const auto torus = [](std::uint32_t around, std::uint32_t along) {
    RigidBody body = boxBody("torus", Vector3::Ones(), Pose::identity());
    body.mesh = std::make_shared<const TriangleMesh>(makeTorus(0.3, 0.1, around, along));
    return body;
  };
  const auto pairsOf = [](const CollisionWorldPtr& world, const Pose& q) {
    const auto query = world->makeQuery();
    query->nearestObstacle(q);
    const std::uint64_t one = query->counts().pairs;
    query->checkMotion(q, Pose::translation(q.position + Vector3(0.01, 0.0, 0.0)), 1e-6, SeekViolation::First, {});
    EXPECT_GE(query->counts().pairs, one);
    return query->counts().pairs;
  };
  const Pose near = Pose::translation({0.0, 0.0, 0.7});
  const CollisionWorldPtr coarse = CollisionWorld::build({torus(8, 6)}, makeL());
  const CollisionWorldPtr fine = CollisionWorld::build({torus(120, 90)}, makeL());
  EXPECT_GT(pairsOf(coarse, near), 0U);
  EXPECT_GT(pairsOf(fine, near), pairsOf(coarse, near));
  EXPECT_EQ(pairsOf(fine, near), pairsOf(fine, near));
  const auto query = fine->makeQuery();
  EXPECT_FALSE(query->collides(Pose::translation({50.0, 0.0, 0.0})));
  EXPECT_EQ(query->counts().pairs, 0U) << "spheres are far apart";
  const CollisionWorldPtr grouped = CollisionWorld::build({torus(8, 6), torus(120, 90)}, makeL())
                                        ->withVariants({{std::make_shared<const TriangleMesh>(*makeL()), {0}}});
  EXPECT_GT(pairsOf(grouped, near), 0U) << "each group counts its own";
}

TEST(LargeWorld, TwoLevelsAnswerAsOneTree) {
  RandomStream stream(1, "levels");
  for (const std::size_t count : {0U, 1U, 2U, 30U}) {
    const std::vector<RigidBody> bodies = randomOccurrences(stream, count);
    const MeshPtr object = makeL();
    KernelQuery one(std::make_shared<const KernelGeometry>(bodies, *object));
    OccurrenceQuery two(occurrencesOf(bodies, *object));
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
      const Pose q = randomPose(stream, 3.0);
      ASSERT_EQ(two.touchingBody(q), one.touchingBody(q));
      ASSERT_EQ(two.touches(q), one.touches(q));
      if (one.touches(q)) {
        ++touching;
        continue;
      }
      const double enough = i % 3 == 0 ? 0.2 : std::numeric_limits<double>::infinity();
      const NearestObstacle a = one.nearest(q, enough);
      const NearestObstacle b = two.nearest(q, enough);
      ASSERT_EQ(b.body, a.body);
      if (a.body < 0) continue;
      ASSERT_NEAR(b.distance, a.distance, 1e-12);
      ASSERT_NEAR((b.p_WPo - b.p_WPn).norm(), b.distance, 1e-12);
      ASSERT_NEAR(boundingBox(*object, q).exteriorDistance(b.p_WPn), 0.0, 1e-9);
      ASSERT_TRUE(two.isWithin(q, a.distance * (1.0 + 1e-9)));
      ASSERT_FALSE(two.isWithin(q, a.distance * (1.0 - 1e-9)));
    }
    EXPECT_EQ(touching > 100, count == 30U);
  }
}

TEST(LargeWorld, TwoLevelsJudgeMotionsAsOneTree) {
  RandomStream stream(2, "motions");
  const std::vector<RigidBody> bodies = randomOccurrences(stream, 30);
  const MeshPtr object = makeL();
  KernelQuery one(std::make_shared<const KernelGeometry>(bodies, *object));
  OccurrenceQuery two(occurrencesOf(bodies, *object));
  int certified = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose from = randomPose(stream, 3.0);
    Pose to = randomPose(stream, 3.0);
    if (i % 3 == 0) to.orientation = from.orientation;
    if (i % 3 == 1) to.orientation = from.orientation * Quaternion(0.0, 0.0, 1.0, 0.0);  // half a turn
    const SeekViolation seek = i % 2 == 0 ? SeekViolation::Any : SeekViolation::First;
    const MotionCheck a = *one.checkMotion(from, to, 1e-3, seek, {});
    const MotionCheck b = *two.checkMotion(from, to, 1e-3, seek, {});
    ASSERT_EQ(b.status, a.status);
    if (a.status == CertificateStatus::Certified) {
      ++certified;
      ASSERT_EQ(b.certified, 1.0);
      continue;
    }
    ASSERT_TRUE(two.isWithin(interpolate(from, to, b.at), 1e-3 * (1.0 + 1e-6)));
    // Both find it to within a thousandth of the object's size, and prove the motion before it.
    if (seek == SeekViolation::Any) continue;
    ASSERT_NEAR(b.at, a.at, 0.02);
    ASSERT_LE(b.certified, b.at);
    ASSERT_LE(b.certified, a.at + 1e-9);
  }
  EXPECT_GT(certified, 100);
}

/// 21 occurrences of one part, with enough triangles for two levels.
struct ManyParts {
  MeshPtr part = std::make_shared<const TriangleMesh>(makeTorus(0.3, 0.1, 100, 50));
  MeshPtr object = std::make_shared<const TriangleMesh>(makeBox({0.1, 0.1, 0.1}));
  std::vector<RigidBody> bodies;

  ManyParts() {
    for (int i = 0; i < 21; ++i) {
      RigidBody body = boxBody("b" + std::to_string(i), Vector3::Ones(), Pose::translation({1.0 * i, 0.0, 0.0}));
      body.mesh = part;
      bodies.push_back(std::move(body));
    }
  }
};

TEST(LargeWorld, AnUpdatedOneAnswersAsOneThatIsBuiltAnew) {
  ManyParts parts;
  RandomStream stream(3, "updated");
  CollisionWorldPtr updated = CollisionWorld::build(parts.bodies, parts.object);
  for (int edit = 0; edit < 6; ++edit) {
    if (edit == 1) parts.bodies[3].X_WB.position.y() += 0.2;
    if (edit == 2) parts.object = std::make_shared<const TriangleMesh>(makeBox({0.2, 0.1, 0.1}));
    if (edit == 3) parts.bodies.push_back(boxBody("plate", {30.0, 0.1, 0.1}, Pose::translation({0.0, 0.6, 0.0})));
    if (edit == 4) parts.bodies.front().X_WB.position.x() = -1e5;  // needs another scale of the kernel
    if (edit == 5) parts.bodies.resize(2);                         // small enough for one tree
    updated = updated->updated(parts.bodies, parts.object);
    const CollisionWorldPtr anew = CollisionWorld::build(parts.bodies, parts.object);
    EXPECT_EQ(updated->obstaclesBox().min(), anew->obstaclesBox().min());
    const auto mine = updated->makeQuery();
    const auto other = anew->makeQuery();
    for (int i = 0; i < 50; ++i) {
      Pose q = randomPose(stream, 0.6);
      q.position.x() += i % 21;
      ASSERT_EQ(mine->collidingBody(q), other->collidingBody(q)) << edit;
      const NearestObstacle a = mine->nearestObstacle(q);
      const NearestObstacle b = other->nearestObstacle(q);
      ASSERT_EQ(a.distance, b.distance) << edit;
      ASSERT_EQ(a.body, b.body) << edit;
      ASSERT_EQ(a.p_WPo, b.p_WPo) << edit;
    }
  }
}

/// A thousand occurrences of a part of 10,000 triangles. Ten million triangles in one tree took a minute and 4 GB.
TEST(LargeWorld, AnotherChoiceOfAThousandOccurrencesIsReadyAtOnce) {
  ManyParts parts;
  parts.bodies.resize(1);
  for (int i = 1; i < 1000; ++i) {
    parts.bodies.push_back(parts.bodies.front());
    parts.bodies.back().X_WB.position = Eigen::Vector3i(i % 10, i / 10 % 10, i / 100).cast<double>();
  }
  const auto seconds = [](const std::function<void()>& work) {
    const auto before = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  };
  CollisionWorldPtr world;
  RecordProperty("build_ms",
                 static_cast<int>(1e3 * seconds([&] { world = CollisionWorld::build(parts.bodies, parts.object); })));
  std::vector<RigidBody> others = parts.bodies;
  const RigidBody object = others[500];
  others.erase(others.begin() + 500);
  const double another = seconds([&] { world = world->updated(others, object.mesh); });
  others[3].X_WB.position.y() += 0.1;
  const double moved = seconds([&] { world = world->updated(others, object.mesh); });
  std::printf("another object: %.1f ms, a body moved: %.1f ms\n", 1e3 * another, 1e3 * moved);
  // Preparing every body anew takes ten seconds and more.
  EXPECT_LT(another, 1.0);
  EXPECT_LT(moved, 1.0);
  EXPECT_EQ(world->makeQuery()->collidingBody(object.X_WB), std::nullopt);
  EXPECT_NEAR(world->makeQuery()->nearestObstacle(object.X_WB).distance, 0.2, 1e-3);
}

TEST(LargeWorld, SeesSolidsInsideEachOther) {
  const ManyParts parts;
  const auto query = CollisionWorld::build(parts.bodies, parts.object)->makeQuery();
  EXPECT_EQ(query->collidingBody(Pose::translation({4.3, 0.0, 0.0})), 4) << "in the tube, touching nothing";
  EXPECT_FALSE(query->collides(Pose::translation({4.0, 0.0, 0.0}))) << "in the hole";
  const auto around = std::make_shared<const TriangleMesh>(makeBox({0.9, 0.9, 0.9}));
  const auto outer = CollisionWorld::build(parts.bodies, around)->makeQuery();
  EXPECT_EQ(outer->collidingBody(Pose::translation({4.0, 0.0, 0.0})), 4) << "around it";
}

TEST(LargeWorld, VariantsCountAgainstTheirObstaclesOnly) {
  const ManyParts parts;
  const auto small = std::make_shared<const TriangleMesh>(makeBox({0.05, 0.05, 0.05}));
  const CollisionWorldPtr whole = CollisionWorld::build(parts.bodies, parts.object);
  const CollisionWorldPtr world = whole->withVariants({{small, {3, 5}}});
  const auto query = world->makeQuery();
  const Vector3 beside(0.0, 0.44, 0.0);
  for (const int body : {2, 3, 4, 5}) {
    const Pose q = Pose::translation(Vector3(1.0 * body, 0.0, 0.0) + beside);
    EXPECT_EQ(query->collides(q), body == 2 || body == 4) << body;
  }
  EXPECT_EQ(world->withVariants({}), whole);
}

TEST(LargeWorld, ATreeOfALargeMeshHoldsItsTriangles) {
  const auto sheet = std::make_shared<const TriangleMesh>(makeTorus(1.0, 0.4, 600, 200));
  RigidBody body = boxBody("large", Vector3::Ones(), Pose::identity());
  body.mesh = sheet;
  const auto object = makeBox({0.1, 0.1, 0.1});
  const auto tree = kernelObstacle(*sheet, 1.0);
  ASSERT_EQ(tree->triangles.size(), sheet->triangles.size());
  std::vector<int> inLeaves(tree->triangles.size(), 0);
  for (const auto& leaf : tree->leaves) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) ++inLeaves[i];
  }
  EXPECT_EQ(std::count(inLeaves.begin(), inLeaves.end(), 1), static_cast<std::ptrdiff_t>(inLeaves.size()));
  const auto again = kernelObstacle(*sheet, 1.0);
  EXPECT_EQ(again->child, tree->child) << "whichever thread built what";
  EXPECT_EQ(again->radius, tree->radius);
  // Compares with the distance from the torus' centre line.
  KernelQuery query(std::make_shared<const KernelGeometry>(1.0, tree, kernelObject(makeBox({1e-6, 1e-6, 1e-6}), 1.0)));
  RandomStream stream(4, "torus");
  for (int i = 0; i < 300; ++i) {
    const Pose q = randomPose(stream, 2.0);
    const double out = std::hypot(q.position.x(), q.position.y()) - 1.0;
    const double distance = std::hypot(out, q.position.z()) - 0.4;
    if (distance < 1e-3) continue;
    ASSERT_NEAR(query.nearest(q, std::numeric_limits<double>::infinity()).distance, distance, 5e-4);
  }
}

}  // namespace
}  // namespace glissade
