#include "engine/sweep/swept_volume.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/base/random_stream.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/sweep/swept_bodies.h"

namespace glissade {
namespace {

/// A random point of a box about the origin.
Vector3 pointOf(const Vector3& sizes, RandomStream& random) {
  Vector3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(-0.5, 0.5) * sizes[axis];
  return p;
}

struct Motion {
  const char* name;
  std::vector<Pose> path;
};

class SweptVolumeOf : public testing::TestWithParam<Motion> {
 protected:
  Vector3 sizes_{0.1, 0.06, 0.03};
  TriangleMesh body_ = makeBox(sizes_);
};

TEST_P(SweptVolumeOf, ContainsTheBodyAtAllTimesAndItsSurfaceIsNear) {
  const std::vector<Pose>& path = GetParam().path;
  const double bound = 0.008;
  const auto sweep = sweptVolume(body_, path, bound);
  ASSERT_TRUE(sweep);
  RandomStream random(3, "swept volume");
  const auto poseAt = [&](double t) {
    const auto edge = std::min(static_cast<std::size_t>(t), path.size() - 2);
    return interpolate(path[edge], path[edge + 1], t - static_cast<double>(edge));
  };
  const double end = static_cast<double>(path.size() - 1);
  for (int i = 0; i < 200; ++i) {
    const Vector3 p_W = poseAt(random.uniform(0.0, end)) * pointOf(sizes_, random);
    EXPECT_NEAR(windingNumber(sweep->surface_W, p_W), 1.0, 1e-6);
  }
  // The distance from the body, by an oracle that knows boxes only.
  for (std::size_t v = 0; v < sweep->surface_W.vertices.size(); v += 97) {
    double nearest = 1e300;
    for (double t = 0.0; t <= end; t += end / 400.0) {
      const Vector3 p_B = inverse(poseAt(t)) * sweep->surface_W.vertices[v];
      nearest = std::min(nearest, (p_B.cwiseAbs() - 0.5 * sizes_).cwiseMax(0.0).norm());
    }
    EXPECT_LE(nearest, bound);
    EXPECT_GT(nearest, 0.0);
  }
}

TEST_P(SweptVolumeOf, IsTheSameEachTime) {
  const auto once = sweptVolume(body_, GetParam().path, 0.01);
  const auto again = sweptVolume(body_, GetParam().path, 0.01);
  ASSERT_TRUE(once && again);
  EXPECT_EQ(once->surface_W.vertices, again->surface_W.vertices);
  EXPECT_EQ(once->surface_W.triangles, again->surface_W.triangles);
}

INSTANTIATE_TEST_SUITE_P(Motions, SweptVolumeOf,
                         testing::Values(Motion{"rest", {Pose::identity(), Pose::identity()}},
                                         Motion{"straight", {Pose::identity(), Pose::translation({0.13, 0.02, -0.05})}},
                                         Motion{"turning",
                                                {Pose::identity(),
                                                 {{0.05, 0.0, 0.02}, fromRollPitchYaw(0.4, 1.0, -0.3)},
                                                 {{0.1, 0.05, 0.0}, fromRollPitchYaw(1.5, 0.2, 2.0)}}}),
                         [](const auto& motion) { return std::string(motion.param.name); });

TEST(SweptVolume, OfAStraightMotionIsThePrismWithARim) {
  const Vector3 sizes(0.1, 0.06, 0.03);
  const Vector3 way(0.2, 0.0, 0.0);
  const auto sweep = sweptVolume(makeBox(sizes), {Pose::identity(), Pose::translation(way)}, 0.008);
  ASSERT_TRUE(sweep);
  const Vector3 swept = sizes + way;
  EXPECT_GT(sweep->volume, swept.prod());
  EXPECT_LT(sweep->volume, (swept.array() + 2.0 * sweep->bound).prod());
}

/// Points of the world's lattice on the border of two blocks of the body's lattice belong to both.
TEST(SweptVolume, OfStraightMotionsHasNoSlits) {
  RandomStream random(7, "slits");
  for (int i = 0; i < 12; ++i) {
    const Vector3 sizes(random.uniform(0.02, 0.03), random.uniform(0.15, 0.2), random.uniform(0.15, 0.2));
    const Vector3 way = 0.1 * Vector3::Unit(i % 3);
    const double bound = 0.02;
    const Pose start = Pose::translation(Vector3(0.1765, 0.075, 0.06) * i);
    const auto sweep = sweptVolume(makeBox(sizes), {start, Pose::translation(start.position + way)}, bound);
    ASSERT_TRUE(sweep);
    double area = 0.0;
    for (const auto& triangle : sweep->surface_W.triangles) {
      const auto& vertices = sweep->surface_W.vertices;
      area +=
          0.5 *
          (vertices[triangle[1]] - vertices[triangle[0]]).cross(vertices[triangle[2]] - vertices[triangle[0]]).norm();
    }
    const Vector3 prism = sizes + way + Vector3::Constant(2.0 * bound);
    EXPECT_LE(area, 2.0 * (prism.x() * prism.y() + prism.y() * prism.z() + prism.z() * prism.x())) << i;
  }
}

TEST(SweptVolume, TheMiddleOfARingIsOutside) {
  std::vector<Pose> path;
  for (int i = 0; i <= 8; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 8.0;
    path.push_back({{0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0}, Quaternion::Identity()});
  }
  const auto ring = sweptVolume(makeBox({0.04, 0.04, 0.04}), path, 0.01);
  ASSERT_TRUE(ring);
  EXPECT_NEAR(windingNumber(ring->surface_W, Vector3::Zero()), 0.0, 1e-6);
}

TEST(SweptVolume, NamesTheBodiesWithin) {
  const auto box = std::make_shared<const TriangleMesh>(makeBox({0.02, 0.02, 0.02}));
  std::vector<RigidBody> bodies(3);
  for (RigidBody& body : bodies) body.mesh = box;
  bodies[0].X_WB = Pose::translation({0.1, 0.0, 0.0});   // on the way
  bodies[1].X_WB = Pose::translation({0.1, 0.2, 0.0});   // beside it
  bodies[2].X_WB = Pose::translation({0.2, 0.06, 0.0});  // at its surface
  const auto sweep =
      sweptVolume(makeBox({0.1, 0.1, 0.1}), {Pose::identity(), Pose::translation({0.2, 0.0, 0.0})}, 0.02);
  ASSERT_TRUE(sweep);
  EXPECT_EQ(bodiesWithin(*sweep, bodies), (std::vector<std::size_t>{0, 2}));
}

TEST(SweptVolume, RefusesWhatItCannotMake) {
  const TriangleMesh box = makeBox({0.1, 0.1, 0.1});
  const std::vector<Pose> path{Pose::identity(), Pose::translation({1.0, 1.0, 1.0})};
  EXPECT_EQ(sweptVolume({}, path, 0.01).error().kind, ErrorKind::Usage);
  EXPECT_EQ(sweptVolume(box, {}, 0.01).error().kind, ErrorKind::Usage);
  EXPECT_EQ(sweptVolume(box, path, 0.0).error().kind, ErrorKind::Usage);
  EXPECT_EQ(sweptVolume(box, path, 1e-6).error().kind, ErrorKind::LimitReached);
  const Pose far = Pose::translation({1e5, 0.0, 0.0});
  EXPECT_EQ(sweptVolume(box, {far, far}, 1e-3).error().kind, ErrorKind::LimitReached);
  StopSource stop;
  stop.requestStop();
  EXPECT_EQ(sweptVolume(box, path, 0.01, stop.token()).error().kind, ErrorKind::Interrupted);
}

TEST(SweptVolume, TheUsualBoundIsReachable) {
  const TriangleMesh box = makeBox({0.1, 0.1, 0.1});
  const std::vector<Pose> longWay{Pose::identity(), Pose::translation({50.0, 50.0, 50.0})};
  const auto longSweep = usualSweptVolume(box, longWay);
  const auto rest = usualSweptVolume(box, {Pose::identity()});
  ASSERT_TRUE(longSweep && rest);
  EXPECT_GT(longSweep->bound, rest->bound);
}

}  // namespace
}  // namespace glissade
