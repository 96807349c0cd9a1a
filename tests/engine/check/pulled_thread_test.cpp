#include "engine/check/pulled_thread.h"

#include <gtest/gtest.h>

#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

constexpr double kPitch = 0.0015;

/// A bolt of 10 mm along z, with a part around it from z = 10 mm to 20 mm.
struct Parts {
  explicit Parts(double holeRadius)
      : overlap(0.005 - holeRadius), around(placed(test::holedPlate(48, holeRadius, 0.009, 0.01, 0.02))) {}

  static PlacedBody placed(TriangleMesh mesh) {
    return PlacedBody(test::checkBody("body", std::move(mesh)), Pose::identity());
  }

  std::string boltLeaves(const std::vector<Pose>& path, bool isCalled = false) const {
    return pulledThread(commonThreads({bolt, around, overlap, isCalled}), path);
  }
  std::string boltStays(const std::vector<Pose>& path, bool isCalled = false) const {
    return pulledThread(commonThreads({around, bolt, overlap, isCalled}), path);
  }

  double overlap;
  PlacedBody bolt = placed(test::prism(40, 0.005, 0.03));
  PlacedBody around;
};

/// Turns about z and rises by the pitch, then goes straight up by 0.1 m.
std::vector<Pose> turned(double turns, double pitch = kPitch, int perTurn = 8) {
  std::vector<Pose> path;
  const int count = static_cast<int>(std::lround(turns * perTurn));
  for (int i = 0; i <= count; ++i) {
    const double turn = static_cast<double>(i) / perTurn;
    path.push_back({Vector3(0.0, 0.0, pitch * turn),
                    Quaternion(Eigen::AngleAxisd(2.0 * std::numbers::pi * turn, Vector3::UnitZ()))});
  }
  path.push_back(path.back());
  path.back().position.z() += 0.1;
  return path;
}

TEST(PulledThread, WhatIsPulledOffAThreadIsSaid) {
  const Parts parts(0.0042);
  EXPECT_EQ(parts.boltStays(turned(0.0)), "20 mm of a thread of 10 mm");
  EXPECT_EQ(parts.boltLeaves(turned(0.0)), "20 mm of a thread of 10 mm");
}

TEST(PulledThread, WhatIsTurnedOffIsNot) {
  const Parts parts(0.0042);
  for (const double pitch : {kPitch, -kPitch}) {
    const double sense = pitch < 0.0 ? -1.0 : 1.0;
    EXPECT_EQ(parts.boltStays(turned(0.02 / kPitch, kPitch)), "");
    std::vector<Pose> mirrored = turned(0.02 / kPitch, kPitch);
    for (Pose& q : mirrored) q.orientation = Quaternion(q.orientation.w(), 0.0, 0.0, sense * q.orientation.z());
    EXPECT_EQ(parts.boltLeaves(mirrored), "") << "of either hand";
  }
}

/// The planner's turns have 64 edges each.
TEST(PulledThread, TurnsOfShortEdgesAreTurns) {
  const Parts parts(0.0042);
  EXPECT_EQ(parts.boltStays(turned(0.02 / kPitch, kPitch, 64)), "");
  EXPECT_NE(parts.boltStays(turned(6, kPitch, 64)), "");
}

TEST(PulledThread, TooFewTurnsAreAPull) {
  const Parts parts(0.0042);
  EXPECT_NE(parts.boltStays(turned(6)), "") << "11 mm of 20 remain";
  EXPECT_NE(parts.boltStays(turned(12)), "") << "2 mm remain, which are more than a pitch";
  EXPECT_EQ(parts.boltStays(turned(12.5)), "") << "the last pitch is the run-out";
}

TEST(PulledThread, AnotherMotionIsAPull) {
  const Parts parts(0.0042);
  EXPECT_NE(parts.boltStays(turned(1.0, 0.02)), "") << "one turn for all of the way is no thread";
  EXPECT_NE(parts.boltStays(turned(20.0, 0.0)), "") << "turned in its place";
  std::vector<Pose> changing = turned(0.02 / kPitch);
  changing[40].position.z() += 1e-4;
  EXPECT_NE(parts.boltStays(changing), "") << "off the turn by 0.1 mm";
  std::vector<Pose> aside = turned(0.02 / kPitch);
  aside[20].position.x() += 1e-4;
  EXPECT_NE(parts.boltStays(aside), "");
  std::vector<Pose> tilted = turned(0.02 / kPitch);
  tilted[20].orientation = tilted[20].orientation * Quaternion(Eigen::AngleAxisd(0.01, Vector3::UnitX()));
  EXPECT_NE(parts.boltStays(tilted), "");
  EXPECT_NE(parts.boltStays(turned(0.02 / kPitch, kPitch, 2)), "") << "edges of half a turn have no sense";
}

TEST(PulledThread, WhatIsPressedOrLooseMayBePulled) {
  EXPECT_EQ(Parts(0.0049).boltStays(turned(0.0)), "") << "thicker by 0.1 mm";
  EXPECT_EQ(Parts(0.0052).boltStays(turned(0.0)), "");
}

/// A ring around a tube: its outside is wider than the hole of the tube, and nothing overlaps.
TEST(PulledThread, MaterialBetweenTwoCylindersIsNoThread) {
  Parts parts(0.0042);
  parts.overlap = 1e-5;
  EXPECT_EQ(parts.boltStays(turned(0.0)), "");
}

TEST(PulledThread, EqualCylindersAreAThreadWhereTheFileSaysSo) {
  const Parts parts(0.005);
  EXPECT_EQ(parts.boltStays(turned(0.0)), "");
  EXPECT_NE(parts.boltStays(turned(0.0), true), "");
  EXPECT_EQ(parts.boltStays(turned(0.02 / kPitch), true), "");
}

/// Fasteners as CAD systems place them: beside their holes by a part of the thread's depth.
TEST(PulledThread, AxesBesideEachOtherAreAThreadWhileTheWallIsInTheShaft) {
  Parts parts(0.0042);
  for (const double beside : {0.00003, 0.0003, 0.00079}) {
    parts.bolt = Parts::placed(transformed(test::prism(40, 0.005, 0.03), Pose::translation({beside, 0.0, 0.0})));
    EXPECT_NE(parts.boltLeaves(turned(0.0)), "") << beside;
    EXPECT_NE(parts.boltStays(turned(0.0)), "") << beside;
    EXPECT_EQ(parts.boltStays(turned(0.02 / kPitch)), "") << beside;
  }
  parts.bolt = Parts::placed(transformed(test::prism(40, 0.005, 0.03), Pose::translation({0.0009, 0.0, 0.0})));
  EXPECT_EQ(parts.boltLeaves(turned(0.0)), "");
}

TEST(PulledThread, EachOfTwoHolesCountsForItself) {
  TriangleMesh two = test::holedPlate(48, 0.0042, 0.009, 0.01, 0.02);
  TriangleMesh far = test::holedPlate(48, 0.0042, 0.009, 0.5, 0.51);
  const auto first = static_cast<std::uint32_t>(two.vertices.size());
  two.vertices.insert(two.vertices.end(), far.vertices.begin(), far.vertices.end());
  for (const auto& [a, b, c] : far.triangles) two.triangles.push_back({a + first, b + first, c + first});
  const PlacedBody around = Parts::placed(two);
  const PlacedBody bolt = Parts::placed(test::prism(40, 0.005, 0.03));
  const std::vector<Pose> path = turned(0.02 / kPitch);
  EXPECT_EQ(pulledThread(commonThreads({around, bolt, 0.0008}), path), "")
      << "free after the length of the hole that it is in";
}

}  // namespace
}  // namespace glissade::check
