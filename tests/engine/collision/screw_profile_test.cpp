#include "engine/collision/screw_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random_stream.h"
#include "engine/check/helix.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/screw_run.h"
#include "samples/nut-and-bolt/shapes.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/support/independent_check.h"

namespace glissade {
namespace {

std::vector<Triangle> trianglesOf(const TriangleMesh& mesh, const Pose& X_WM = {}) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({X_WM * mesh.vertices[a], X_WM * mesh.vertices[b], X_WM * mesh.vertices[c]});
  }
  return triangles;
}

RigidBody bodyOf(TriangleMesh mesh) {
  RigidBody body;
  body.id = "body";
  body.name = "body";
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

check::Helix helixOf(const ScrewAxis& screw, double advance) {
  check::Helix helix;
  helix.point = screw.point_W;
  helix.axis = screw.axis_W;
  helix.lead = screw.pitch;
  helix.advance = advance;
  return helix;
}

/// Random triangles about a point.
TriangleMesh randomTriangles(RandomStream& random, const Vector3& middle, double size) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Vector3 at = middle + 0.3 * Vector3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.push_back(at +
                              size * Vector3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// The planner's and the judge's bounds are never above the distance at any configuration of the motion.
TEST(ScrewProfile, BoundsAreBelowTheDistancesOfRandomTriangles) {
  RandomStream random(7, "screw profile");
  int shown = 0;
  for (int trial = 0; trial < 200; ++trial) {
    ScrewAxis screw;
    screw.axis_W = Vector3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5).normalized();
    screw.point_W = 0.1 * Vector3(random.uniform(), random.uniform(), random.uniform());
    screw.pitch = (random.uniform() < 0.5 ? -1.0 : 1.0) * (0.2 + random.uniform());
    const double advance = (random.uniform() - 0.5) * 3.0;
    const auto place = [&] {
      return Vector3(1.5 * (random.uniform() - 0.5), 1.5 * (random.uniform() - 0.5), random.uniform() - 0.5);
    };
    const TriangleMesh moving = randomTriangles(random, place(), 0.15);
    const RigidBody fixed = bodyOf(randomTriangles(random, place(), 0.15));
    const auto query = CollisionWorld::build({fixed}, std::make_shared<const TriangleMesh>(moving))->makeQuery();
    double least = query->nearestObstacle(Pose::identity()).distance;
    const double bound = screwDistance(trianglesOf(moving), trianglesOf(*fixed.mesh), screw, advance, least, least);
    const double judged = check::helixDistance(trianglesOf(moving), trianglesOf(*fixed.mesh), helixOf(screw, advance),
                                               0.5 * bound, least, {});
    for (int i = 0; i <= 400; ++i) {
      least = std::min(least, query->nearestObstacle(screwed(screw, Pose::identity(), advance * i / 400)).distance);
    }
    EXPECT_LE(bound, least + 1e-12);
    EXPECT_LE(judged, least + 1e-12);
    shown += bound > 0.0 && judged > 0.0;
  }
  EXPECT_GT(shown, 50);
}

struct Threaded {
  explicit Threaded(const nut_and_bolt::Shape& shape)
      : screw{Vector3::Zero(), Vector3::UnitZ(), shape.pitch},
        nut(std::make_shared<const TriangleMesh>(nut_and_bolt::nut(shape))),
        bolt(bodyOf(nut_and_bolt::bolt(shape))),
        world(CollisionWorld::build({bolt}, nut)) {}

  std::vector<Pose> path(double advance, int pieces) const {
    const Pose start = Pose::translation({0.0, 0.0, 2.0 * std::abs(screw.pitch)});
    std::vector<Pose> poses;
    for (int i = 0; i <= pieces; ++i) poses.push_back(screwed(screw, start, advance * i / pieces));
    return poses;
  }

  ScrewAxis screw;
  MeshPtr nut;
  RigidBody bolt;
  CollisionWorldPtr world;
};

TEST(ScrewProfile, ProvesManyTurnsOfAThread) {
  for (const double hand : {1.0, -1.0}) {
    nut_and_bolt::Shape shape;
    shape.pitch *= hand;
    const Threaded parts(shape);
    const auto path = parts.path(4.0 * nut_and_bolt::kPitch, 4 * 16);
    const auto query = parts.world->makeQuery();
    const MotionCertificate certificate = certifyPath(*query, path, 1e-6);
    EXPECT_EQ(certificate.status, CertificateStatus::Certified);
    EXPECT_GT(certificate.provedClearance, 1e-5);
    if (hand < 0.0) continue;  // the judge compares every pair
    const std::vector<EdgeDemand> demands(path.size() - 1, {1e-6, false});
    const MotionCertificate judged = IndependentCheck({parts.bolt}, *parts.nut).check(path, demands);
    EXPECT_EQ(judged.status, CertificateStatus::Certified);
    EXPECT_GE(judged.provedClearance, 1e-6);
    EXPECT_LE(judged.distanceQueries, 100U * path.size());
  }
}

/// A part of the rounding under a screw's head, which is 0.02 mm below the edge of its hole's large face and inside of
/// it. Their radii and heights overlap, and the angles of the face are so inaccurate that (r, s) do not help.
TEST(ScrewProfile, ProvesATurnOverTheEdgeOfALargeFace) {
  constexpr int kSides = 36;
  std::vector<Triangle> rounding;
  const auto at = [](double radius, double z, int i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    return Vector3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int i = 0; i < kSides; ++i) {
    const Vector3 a = at(2.5795e-3, -6.61e-5, i);
    const Vector3 b = at(2.5795e-3, -6.61e-5, i + 1);
    const Vector3 c = at(2.6331e-3, -3.56e-5, i);
    const Vector3 d = at(2.6331e-3, -3.56e-5, i + 1);
    rounding.push_back({a, b, d});
    rounding.push_back({a, d, c});
  }
  const std::vector<Triangle> plate = trianglesOf(test::holedPlate(58, 2.63e-3, 0.037, -4e-3, -6.44e-5));
  const ScrewAxis screw{Vector3::Zero(), Vector3::UnitZ(), 0.794e-3};
  constexpr double kRequired = 1e-7;
  EXPECT_GE(screwDistance(rounding, plate, screw, 9.7 * screw.pitch, 1.7e-5, kRequired), kRequired);
  EXPECT_EQ(screwDistance(rounding, plate, screw, -0.1 * screw.pitch, 1.7e-5, kRequired), 0.0) << "into the face";
}

/// With a pitch that is off by a few percent the flanks meet after some turns.
TEST(ScrewProfile, RefusesTheWrongPitch) {
  Threaded parts{nut_and_bolt::Shape{}};
  parts.screw.pitch *= 1.1;
  const auto path = parts.path(5.0 * nut_and_bolt::kPitch, 5 * 16);
  const std::vector<EdgeDemand> demands(path.size() - 1, {1e-6, false});
  EXPECT_EQ(certifyPath(*parts.world->makeQuery(), path, 1e-6).status, CertificateStatus::Violated);
  EXPECT_EQ(IndependentCheck({parts.bolt}, *parts.nut).check(path, demands).status, CertificateStatus::Violated);
}

/// The motion goes down to the head, and through it.
TEST(ScrewProfile, RefusesAMotionIntoTheHead) {
  const Threaded parts{nut_and_bolt::Shape{}};
  const auto path = parts.path(-2.5 * nut_and_bolt::kPitch, 40);
  EXPECT_EQ(certifyPath(*parts.world->makeQuery(), path, 1e-6).status, CertificateStatus::Violated);
}

TEST(ScrewRun, FindsTheScrewMotionOfAPath) {
  RandomStream random(3, "runs");
  const ScrewAxis screw{{0.1, 0.2, 0.3}, Vector3(1.0, 2.0, -1.0).normalized(), -0.02};
  Pose start;
  start.position = {0.4, 0.1, 0.2};
  start.orientation = Quaternion(Eigen::AngleAxisd(0.7, Vector3::UnitX()));
  std::vector<Pose> path{Pose::identity()};
  for (int i = 0; i <= 60; ++i) path.push_back(screwed(screw, start, 0.05 * i / 60));
  path.push_back(Pose::identity());
  const auto runs = screwRunsOf(path, 0.1);
  const auto judged = check::helicesOf(path, nut_and_bolt::nut());
  ASSERT_EQ(runs.size(), 1U);
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_EQ(runs.front().first, 1U);
  EXPECT_EQ(runs.front().last, 60U);
  EXPECT_EQ(judged.front().first, 1U);
  EXPECT_EQ(judged.front().last, 60U);
  EXPECT_NEAR(std::abs(runs.front().screw.pitch), 0.02, 1e-9);
  EXPECT_NEAR(std::abs(judged.front().lead), 0.02, 1e-9);
  EXPECT_LT((runs.front().screw.point_W - screw.point_W).cross(screw.axis_W).norm(), 1e-9);
  // The chords deviate from the helix by this much, and no configuration on them deviates by more than the stated
  // bound.
  EXPECT_GT(runs.front().off, 1e-4);
  for (std::size_t i = 1; i <= 60; ++i) {
    const Pose exact = screwed(screw, start, 0.05 * (static_cast<double>(i) - 0.5) / 60);
    const double off = (interpolate(path[i], path[i + 1], 0.5).position - exact.position).norm();
    EXPECT_LE(off, runs.front().off);
    EXPECT_LE(off, judged.front().off);
  }
}

}  // namespace
}  // namespace glissade
