#include "engine/collision/thread_rule.h"

#include <gtest/gtest.h>

#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

using test::kCoarsePitch;

/// Position of a nut near the lower end of a bolt, turned and placed at random; its reference point is off the axis.
constexpr double kNutAt = -0.0165;

struct NutOnBolt {
  NutOnBolt(RandomStream& random, bool nutMoves, const FitSettings& settings = test::markedThread()) {
    place = randomPose(random, 0.3);
    axis = place.orientation * Vector3::UnitZ();
    const Vector3 aside(0.0004, -0.0003, 0.001);
    TriangleMesh nut = transformed(test::hexNut(), Pose::translation(-aside));
    const Pose nutAt = place * Pose::translation({0.0, 0.0, kNutAt}) * Pose::translation(aside);
    RigidBody one = test::partAt("nut", std::move(nut), nutAt);
    RigidBody other = test::partAt("bolt", test::plainBolt(), place);
    object = nutMoves ? one : other;
    obstacles = {nutMoves ? other : one};
    auto found = test::fitted(obstacles, object, {object.X_WB}, settings);
    if (found) parts = std::move(*found);
  }

  const ThreadRule& rule() const { return parts.fits.allowed.front().thread->rule; }

  MotionCertificate judged(const std::vector<Pose>& path) const {
    const IndependentCheck judge(parts.fits.allowed, parts.product, threadRulesOf(parts.fits.allowed));
    return judge.check(path, std::vector<EdgeDemand>(path.size() - 1, {1e-7, false}));
  }
  bool planned(const std::vector<Pose>& path) const {
    const auto query = parts.world->makeQuery();
    return !firstRefusedEdge(*query, path, std::vector<EdgeDemand>(path.size() - 1, {1e-7, false}));
  }
  /// A screw motion of `turns` turns with this pitch.
  std::vector<Pose> turning(double turns, double pitch, int pieces) const {
    ThreadRule own = rule();
    own.pitch = pitch;
    std::vector<Pose> path;
    for (int i = 0; i <= pieces; ++i) path.push_back(screwed(own, object.X_WB, turns * pitch * i / pieces));
    return path;
  }
  std::vector<Pose> pulled(const Vector3& way) const {
    Pose end = object.X_WB;
    end.position += way;
    return {object.X_WB, end};
  }

  Pose place;
  Vector3 axis;
  RigidBody object;
  std::vector<RigidBody> obstacles;
  test::FittedParts parts;
};

TEST(ThreadRule, AScrewAdvancesByItsPitchWithEachTurn) {
  RandomStream random(1, "screw");
  const NutOnBolt nut(random, true);
  ASSERT_EQ(nut.parts.fits.allowed.size(), 1U);
  ASSERT_TRUE(nut.parts.fits.allowed.front().thread);
  EXPECT_EQ(nut.rule().pitch, kCoarsePitch);
  EXPECT_EQ(nut.parts.fits.allowed.front().thread->size, "M10");
  const Pose turned = screwed(nut.rule(), nut.object.X_WB, 0.25 * kCoarsePitch);
  EXPECT_NEAR(angleBetween(turned.orientation, nut.object.X_WB.orientation), 0.5 * 3.14159265358979, 1e-9);
  // Right-handed: a point beside the axis moves in the direction axis x arm.
  const Vector3 arm = nut.rule().axis_W.unitOrthogonal();
  const Vector3 before = nut.rule().point_W + arm;
  const Vector3 after = turned * (inverse(nut.object.X_WB) * before);
  const Vector3 expected = nut.rule().point_W + nut.rule().axis_W.cross(arm) + 0.25 * kCoarsePitch * nut.rule().axis_W;
  EXPECT_NEAR((after - expected).norm(), 0.0, 1e-9);
}

/// Many turns are proved as one motion only where they are the rule's, and the whole object is clear beyond the thread.
TEST(ThreadRule, AScrewMotionOfManyTurnsIsProvedAtOnceWhereTheRulePermitsIt) {
  RandomStream random(5, "at once");
  const NutOnBolt nut(random, true);
  const ThreadRule& rule = nut.rule();
  const double sense = rule.axis_W.dot(nut.axis) > 0.0 ? -1.0 : 1.0;
  const auto query = nut.parts.world->makeQuery();
  constexpr double kEnough = 1e-5;
  const auto shown = [&](const Pose& from, double pitch, double advance, double off) {
    return query->screwClearance(from, {rule.point_W, rule.axis_W, pitch}, advance, kEnough, off);
  };
  const double out = sense * 4.0 * kCoarsePitch;
  const Pose end = screwed(rule, nut.object.X_WB, out);
  EXPECT_GT(shown(nut.object.X_WB, rule.pitch, out, 0.0), 1e-7);
  EXPECT_GT(shown(end, rule.pitch, -out, 0.0), 1e-7) << "on again";
  EXPECT_EQ(shown(nut.object.X_WB, 1.01 * rule.pitch, out, 0.0), 0.0) << "another pitch";
  EXPECT_EQ(shown(nut.object.X_WB, -rule.pitch, out, 0.0), 0.0) << "left-handed";
  EXPECT_EQ(shown(nut.object.X_WB, rule.pitch, out, 0.021 * kCoarsePitch), 0.0) << "off by more than the play";
  EXPECT_EQ(shown(end, rule.pitch, out, 0.0), 0.0) << "no thread is engaged there";
  Pose pulled = nut.object.X_WB;
  pulled.position += 0.1 * kCoarsePitch * nut.axis;
  EXPECT_EQ(shown(pulled, rule.pitch, out, 0.0), 0.0) << "off the screw";

  const auto counted = [&](const std::vector<Pose>& path) {
    const auto own = nut.parts.world->makeQuery();
    const MotionCertificate certificate = certifyPath(*own, path, 1e-7);
    EXPECT_EQ(certificate.status, CertificateStatus::Certified);
    EXPECT_GE(certificate.provedClearance, 1e-7);
    return own->counts().motion;
  };
  const std::vector<Pose> path = nut.turning(sense * 4.0, rule.pitch, 64);
  EXPECT_LT(counted(path), path.size() / 4) << "edges were proved one by one";
}

TEST(ThreadRule, ManyTurnsAreCertifiedAndAPullIsNot) {
  RandomStream random(2, "many turns");
  for (const bool nutMoves : {true, false}) {
    FitSettings settings = test::markedThread();
    settings.pairs.front().turned = BodyId(nutMoves ? "nut" : "bolt");
    const NutOnBolt parts(random, nutMoves, settings);
    constexpr double kTurnsOut = 3.0;
    ASSERT_EQ(parts.parts.fits.allowed.size(), 1U);
    // The rule's axis may have either direction.
    const double sense = (nutMoves ? -1.0 : 1.0) * (parts.rule().axis_W.dot(parts.axis) > 0.0 ? 1.0 : -1.0);
    const std::vector<Pose> out = parts.turning(sense * kTurnsOut, kCoarsePitch, 16 * static_cast<int>(kTurnsOut));
    EXPECT_TRUE(parts.planned(out));
    const MotionCertificate judged = parts.judged(out);
    EXPECT_EQ(judged.status, CertificateStatus::Certified);
    EXPECT_EQ(judged.edges.size(), out.size() - 1);
    const ThreadPair pair(parts.rule(), *parts.object.mesh, parts.obstacles.front());
    EXPECT_TRUE(pair.engaged(out.front()));
    EXPECT_FALSE(pair.engaged(out.back()));
    EXPECT_NEAR(std::abs(turnsWhileEngaged(pair, out)), std::abs(pair.advanceOut(out.front(), sense)) / kCoarsePitch,
                0.1);

    for (const double length : {0.0002, 0.01, 0.1, -0.1}) {
      const std::vector<Pose> pull = parts.pulled(length * parts.axis);
      EXPECT_FALSE(parts.planned(pull)) << length;
      const MotionCertificate refused = parts.judged(pull);
      EXPECT_EQ(refused.status, CertificateStatus::Violated) << length;
      EXPECT_TRUE(refused.againstThread);
      EXPECT_EQ(refused.nearest.body, 0);
    }
  }
}

TEST(ThreadRule, OnlyThePitchOfTheThreadIsAllowed) {
  RandomStream random(3, "pitch");
  const NutOnBolt nut(random, true);
  for (const double pitch : {-kCoarsePitch, 1.1 * kCoarsePitch, 0.9 * kCoarsePitch, 2.0 * kCoarsePitch, 1e-9}) {
    const std::vector<Pose> path = nut.turning(2.0, pitch, 40);
    EXPECT_FALSE(nut.planned(path)) << pitch;
    EXPECT_TRUE(nut.judged(path).againstThread) << pitch;
  }
  FitSettings left = test::markedThread();
  left.pairs.front().pitch = -0.002;
  const NutOnBolt other(random, true, left);
  EXPECT_TRUE(other.parts.fits.allowed.front().thread->size.empty());
  EXPECT_TRUE(other.planned(other.turning(2.0, -0.002, 40)));
  EXPECT_EQ(other.judged(other.turning(2.0, -0.002, 40)).status, CertificateStatus::Certified);
  EXPECT_FALSE(other.planned(other.turning(2.0, 0.002, 40)));
}

/// A turn forwards followed by a pull by a whole pitch ends on the thread, too.
TEST(ThreadRule, APullByAWholePitchIsRefused) {
  RandomStream random(4, "whole pitch");
  const NutOnBolt nut(random, true);
  std::vector<Pose> path = nut.turning(1.0, kCoarsePitch, 20);
  path.push_back(path.back());
  path.back().position += kCoarsePitch * nut.rule().axis_W;
  EXPECT_FALSE(nut.planned(path));
  const MotionCertificate judged = nut.judged(path);
  EXPECT_TRUE(judged.againstThread);
  EXPECT_EQ(judged.edge, 20U);
}

TEST(ThreadRule, PlannerAndJudgeAgreeOnRandomMotions) {
  RandomStream random(5, "agree");
  const NutOnBolt nut(random, true);
  int free = 0;
  const double sense = nut.rule().axis_W.dot(nut.axis) > 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 12; ++i) {
    const double turns = random.uniform(1.0, 2.6);
    std::vector<Pose> path = nut.turning(sense * turns, kCoarsePitch, static_cast<int>(20 * turns));
    path.push_back(path.back());
    path.back().position += random.uniform(-0.02, 0.02) * nut.axis + 0.01 * randomPose(random, 1.0).position;
    const bool planned = nut.planned(path);
    const MotionCertificate judged = nut.judged(path);
    EXPECT_EQ(planned, judged.status == CertificateStatus::Certified) << i << ", " << turns << " turns";
    free += planned ? 1 : 0;
  }
  EXPECT_GT(free, 2);
  EXPECT_LT(free, 11);
}

TEST(ThreadRule, OffTheThreadTheObjectIsWhole) {
  RandomStream random(6, "whole");
  const NutOnBolt nut(random, true);
  const auto query = nut.parts.world->makeQuery();
  EXPECT_FALSE(query->collides(nut.object.X_WB));
  Pose moved = nut.object.X_WB;
  moved.position += 0.3 * kCoarsePitch * nut.axis;
  EXPECT_EQ(query->collidingBody(moved), 0);
  EXPECT_EQ(query->nearestObstacle(moved).distance, 0.0);
  moved.position += nut.axis.unitOrthogonal();
  EXPECT_FALSE(query->collides(moved));
  const auto without = nut.parts.world->withVariants({});
  EXPECT_TRUE(without->threads().empty());
  const auto fcl = nut.parts.world->withBackend(CollisionBackend::Fcl);
  EXPECT_EQ(fcl->threads().size(), 1U);
  EXPECT_FALSE(fcl->makeQuery()->collides(nut.object.X_WB));
}

}  // namespace
}  // namespace glissade
