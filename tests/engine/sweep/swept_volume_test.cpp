#include "engine/sweep/swept_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/base/random_stream.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/geometry/solid_interior.h"
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
  // The distance from the body, by an oracle that only knows boxes.
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

/// A motion along which every point is sampled densely: the oracle of the covered volume.
class SampledMotion {
 public:
  SampledMotion(const TriangleMesh& body, const std::vector<Pose>& path, int posesOfAnEdge)
      : interior_(body, true), box_(boundingBox(body)) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      for (int k = 0; k <= posesOfAnEdge; ++k) {
        toBody_.push_back(inverse(interpolate(path[i - 1], path[i], static_cast<double>(k) / posesOfAnEdge)));
      }
    }
  }

  bool covers(const Vector3& p_W) const {
    return std::any_of(toBody_.begin(), toBody_.end(), [&](const Pose& X_BW) {
      const Vector3 p_B = X_BW * p_W;
      return box_.contains(p_B) && interior_.contains(p_B);
    });
  }

 private:
  SolidInterior interior_;
  Box3 box_;
  std::vector<Pose> toBody_;
};

/// The object of environment 1: two bars that overlap.
TriangleMesh makeBentBar() {
  TriangleMesh bar = makeBox({0.4, 0.4, 0.4});
  append(bar, transformed(makeBox({0.4, 0.4, 1.6}), Pose::translation({0.4, 0.0, 0.6})));
  return bar;
}

/// A block with a hole through it, such as a nut.
TriangleMesh makeFrame() {
  TriangleMesh frame;
  for (const double side : {-1.0, 1.0}) {
    append(frame, transformed(makeBox({0.02, 0.006, 0.01}), Pose::translation({0.0, side * 0.007, 0.0})));
    append(frame, transformed(makeBox({0.006, 0.02, 0.01}), Pose::translation({side * 0.007, 0.0, 0.0})));
  }
  return frame;
}

std::vector<Pose> helix(double pitch, int edges) {
  std::vector<Pose> path;
  for (int i = 0; i <= edges; ++i) {
    const double angle = 0.5 * i;
    path.push_back({{0.0, 0.0, pitch * angle / (2.0 * std::numbers::pi)}, fromRotationVector({0.0, 0.0, angle})});
  }
  return path;
}

std::vector<Pose> randomPath(RandomStream& random, double size, int edges) {
  std::vector<Pose> path;
  for (int i = 0; i <= edges; ++i) {
    path.push_back(
        {pointOf(Vector3::Constant(2.0 * size), random), fromRotationVector(pointOf({4.0, 4.0, 4.0}, random))});
  }
  return path;
}

struct UsualCase {
  const char* name;
  TriangleMesh body;
  std::vector<Pose> path;
};

class UsualSweptVolume : public testing::TestWithParam<UsualCase> {};

TEST_P(UsualSweptVolume, ContainsTheBodyAndIsNoMoreThanATenthLarger) {
  const auto& [name, body, path] = GetParam();
  const auto sweep = usualSweptVolume(body, path);
  ASSERT_TRUE(sweep);
  EXPECT_TRUE(audit(sweep->surface_W).closed());
  const SolidInterior within(sweep->surface_W, true);
  RandomStream random(5, name);
  for (int i = 0; i < 20000; ++i) {
    const TriangleIndices& triangle = body.triangles[random.bits() % body.triangles.size()];
    const double u = random.uniform(0.0, 1.0);
    const double v = random.uniform(0.0, 1.0 - u);
    const Vector3& corner = body.vertices[triangle[0]];
    const Vector3 p_B =
        corner + (i % 2) * (u * (body.vertices[triangle[1]] - corner) + v * (body.vertices[triangle[2]] - corner));
    const std::size_t edge = random.bits() % (path.size() - 1);
    EXPECT_TRUE(within.contains(interpolate(path[edge], path[edge + 1], random.uniform(0.0, 1.0)) * p_B));
  }
  const SampledMotion motion(body, path, 200);
  const Box3 box = boundingBox(sweep->surface_W);
  int inside = 0;
  int covered = 0;
  while (inside < 3000) {
    const Vector3 p_W = box.center() + pointOf(box.sizes(), random);
    if (!within.contains(p_W)) continue;
    ++inside;
    covered += motion.covers(p_W) ? 1 : 0;
  }
  EXPECT_LE(inside, 1.10 * covered);
  EXPECT_NEAR(sweep->excess, static_cast<double>(inside) / covered - 1.0, 0.03);
}

std::vector<UsualCase> usualCases() {
  RandomStream random(1, "usual sweeps");
  return {{"bar", makeBentBar(), randomPath(random, 2.0, 4)}, {"nut", makeFrame(), helix(0.002, 12)}};
}

INSTANTIATE_TEST_SUITE_P(Bodies, UsualSweptVolume, testing::ValuesIn(usualCases()),
                         [](const auto& usual) { return std::string(usual.param.name); });

TEST(SweptVolume, OfAnySizeIsTheSame) {
  for (const double size : {6e-6, 1.0, 100.0}) {
    const TriangleMesh box = makeBox(size * Vector3(1.0, 0.6, 0.3));
    std::vector<Pose> path{Pose::identity(), {size * Vector3(0.5, 1.0, 0.0), fromRollPitchYaw(0.4, 1.0, -0.3)}};
    const auto sweep = usualSweptVolume(box, path);
    ASSERT_TRUE(sweep) << toString(sweep.error().reason);
    EXPECT_LT(sweep->excess, 0.08);
    EXPECT_LT(sweep->bound, 0.1 * size);
  }
}

TEST(SweptVolume, OfAMotionWithoutWayAndOfATurnOnly) {
  const TriangleMesh box = makeBox({0.1, 0.06, 0.03});
  const double atRest = 0.1 * 0.06 * 0.03;
  const auto rest = usualSweptVolume(box, {Pose::identity()});
  ASSERT_TRUE(rest);
  EXPECT_GT(rest->volume, atRest);
  EXPECT_LT(rest->volume, 1.1 * atRest);
  const auto turn = usualSweptVolume(box, {Pose::identity(),
                                           {Vector3::Zero(), fromRollPitchYaw(0.0, 0.0, 1.5)},
                                           {Vector3::Zero(), fromRollPitchYaw(0.0, 0.0, 3.0)},
                                           {Vector3::Zero(), fromRollPitchYaw(0.0, 0.0, 4.5)}});
  ASSERT_TRUE(turn);
  const double disc = std::numbers::pi * 0.25 * (0.1 * 0.1 + 0.06 * 0.06) * 0.03;
  EXPECT_GT(turn->volume, disc);
  EXPECT_LT(turn->volume, 1.1 * disc);
}

TEST(SweptVolume, OfAnOpenMeshIsAShellAroundIt) {
  TriangleMesh sheet;
  sheet.vertices = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}};
  sheet.triangles = {{0, 1, 2}};
  const std::vector<Pose> path{Pose::identity(), Pose::translation({0.0, 0.0, 0.05})};
  const auto sweep = sweptVolume(sheet, path, 0.004);
  ASSERT_TRUE(sweep);
  EXPECT_TRUE(audit(sweep->surface_W).closed());
  EXPECT_GT(sweep->volume, 0.5 * 0.1 * 0.1 * 0.05);
  EXPECT_LT(sweep->volume, 1.5 * 0.5 * 0.1 * 0.1 * 0.05);
  const auto still = sweptVolume(sheet, {Pose::identity()}, 0.004);
  ASSERT_TRUE(still);
  EXPECT_NEAR(windingNumber(still->surface_W, {0.03, 0.03, 0.0}), 1.0, 1e-6);
  EXPECT_LE(still->bound, 0.004);
}

TEST(SweptVolume, TellsItsProgressAndStops) {
  std::vector<double> shares;
  const TriangleMesh box = makeBox({0.1, 0.06, 0.03});
  const std::vector<Pose> path{Pose::identity(), Pose::translation({0.3, 0.2, 0.1})};
  StopSource stop;
  const WorkWatch watch(stop.token(), [&](double share) {
    shares.push_back(share);
    if (shares.size() == 3) stop.requestStop();
  });
  const auto sweep = sweptVolume(box, path, 0.001, watch);
  ASSERT_FALSE(sweep);
  EXPECT_EQ(sweep.error().kind, ErrorKind::Interrupted);
  EXPECT_GE(shares.size(), 3U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
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
  const std::vector<Pose> longWay{Pose::identity(), Pose::translation({4.0, 4.0, 4.0})};
  const auto longSweep = usualSweptVolume(box, longWay);
  const auto rest = usualSweptVolume(box, {Pose::identity()});
  ASSERT_TRUE(longSweep && rest);
  EXPECT_GT(longSweep->bound, rest->bound);
}

}  // namespace
}  // namespace glissade
