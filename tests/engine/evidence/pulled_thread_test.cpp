#include "engine/evidence/pulled_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/base/random_stream.h"
#include "engine/evidence/crests.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/fits/grooved_shafts.h"
#include "tests/engine/fits/turned_parts.h"

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
    return toString(pulledThread(commonThreads({bolt, around, overlap, isCalled}), path));
  }
  std::string boltStays(const std::vector<Pose>& path, bool isCalled = false) const {
    return toString(pulledThread(commonThreads({around, bolt, overlap, isCalled}), path));
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

/// A horn on the spline of a servo is thicker by a fifth of a coarse pitch. A screw in plastic may be, too.
TEST(PulledThread, WhatIsLessThickThanAThreadIsDeepMayBePulled) {
  const Parts parts(0.005 - 0.2 * kPitch);
  EXPECT_EQ(parts.boltStays(turned(0.0)), "");
  EXPECT_EQ(parts.boltLeaves(turned(0.0)), "");
  const LeavingPair named{parts.bolt, parts.around, parts.overlap, false, nullptr, "screw M10x20"};
  EXPECT_NE(toString(pulledThread(commonThreads(named), turned(0.0))), "");
  EXPECT_NE(Parts(0.005 - 0.32 * kPitch).boltStays(turned(0.0)), "") << "the hole has the pitch diameter";
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

/// Names and shapes decide whether a prism with a hole of 10 mm is a nut on a shaft of the same width.
bool isPulledNut(const std::string& name, double across, double height, const std::string& shaft = "") {
  const PlacedBody rod = Parts::placed(test::rodMesh(0.005, 0.0, 0.03));
  const PlacedBody nut =
      Parts::placed(test::tubeMesh(test::circle(0.005), test::prism(across, 6), 0.01, 0.01 + height));
  const bool isPulled = !pulledThread(commonThreads({nut, rod, 0.0, false, nullptr, name, shaft}), turned(0.0)).empty();
  EXPECT_EQ(!pulledThread(commonThreads({rod, nut, 0.0, false, nullptr, shaft, name}), turned(0.0)).empty(), isPulled);
  return isPulled;
}

TEST(PulledThread, ANutOnAShaftAsWideAsItsHoleIsAThread) {
  EXPECT_TRUE(isPulledNut("", 0.016, 0.008)) << "the shape of a nut M10";
  EXPECT_FALSE(isPulledNut("", 0.026, 0.008)) << "a hexagonal plate";
  EXPECT_FALSE(isPulledNut("", 0.016, 0.05)) << "a column";
  EXPECT_FALSE(isPulledNut("nut M8", 0.013, 0.008)) << "of another size than the shaft";
  EXPECT_FALSE(isPulledNut("nut", 0.016, 0.008, "dowel pin")) << "a pin has no thread";
  for (const char* smooth : {"608 bearing", "washer 10.5", "O-ring 10x2"})
    EXPECT_FALSE(isPulledNut("nut", 0.016, 0.008, smooth)) << smooth;
  const Parts round(0.005);
  EXPECT_EQ(round.boltStays(turned(0.0)), "") << "a washer";
  const LeavingPair named{round.around, round.bolt, 0.0, false, nullptr, "round nut"};
  EXPECT_NE(toString(pulledThread(commonThreads(named), turned(0.0))), "") << "by its name";
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

/// A shaft of 10 mm in a hole that is drawn narrower than its crests, and pulled.
struct Relieved {
  const char* what;
  test::Relief relief;
  bool isThread;                     ///< it has to be turned
  std::string name{};                ///< may state its size
  Vector3 beside = Vector3::Zero();  ///< where its axis is
};

/// None that is threaded is pulled; what has no thread may be pulled.
TEST(PulledThread, ModelledThreadsAreNotPulledAndOtherReliefsAre) {
  using namespace glissade::test;
  const double crest = 0.005;
  const double root = 0.004;
  const PlacedBody boss = Parts::placed(blockMesh(0.0044, 0.03, 0.03, -0.04, -0.002));
  for (const Relieved& each :
       {Relieved{"a helix", helix(crest, root, 0.0015), true},
        Relieved{"left-handed", helix(crest, root, -0.0015), true},
        Relieved{"coarse, for plastic", helix(crest, 0.003, 0.0039), true},
        Relieved{"beside its hole", helix(crest, root, 0.0015), true, {}, {2e-4, 1e-4, 0.0}},
        Relieved{"fine", helix(crest, 0.0046, 0.00075), true},
        Relieved{"of two starts", helix(crest, root, 0.003, 2), true},
        Relieved{"of four starts, as a lead screw", helix(crest, root, 0.008, 4), true},
        Relieved{"of three starts, left-handed", helix(crest, root, -0.006, 3), true},
        Relieved{"rings of a screw", rings(crest, root, 0.0015), true, "screw M10x20"},
        Relieved{"rings", rings(crest, root, 0.0015), false}, Relieved{"barbs", barbs(crest, root, 0.003), false},
        Relieved{"a knurl along it", straightKnurl(crest, root, 24), false},
        Relieved{"a knurl of a screw", straightKnurl(crest, root, 24), false, "screw M10x20"},
        Relieved{"a diamond knurl", diamondKnurl(crest, root, 0.008, 18), false},
        Relieved{"hammered in", helix(crest, root, 0.025, 6), false},
        Relieved{"a smooth dowel", smooth(0.00444), false},
        Relieved{"a groove for a ring", ringGroove(0.00444, root, -0.01, 0.002), false}}) {
    const TriangleMesh mesh = groovedShaft(each.relief, 0.02, crest, ShaftHead::Round, 240);
    const PlacedBody shaft = Parts::placed(transformed(mesh, Pose::translation(each.beside)));
    const std::vector<CommonThread> out = commonThreads({shaft, boss, 0.0006, false, nullptr, each.name});
    const std::vector<CommonThread> off = commonThreads({boss, shaft, 0.0006, false, nullptr, {}, each.name});
    EXPECT_EQ(!pulledThread(out, turned(0.0)).empty(), each.isThread) << each.what;
    EXPECT_EQ(!pulledThread(off, turned(0.0)).empty(), each.isThread) << each.what;
  }
}

/// The pitch is that of the model, and for several starts its lead; rings state none.
TEST(PulledThread, AHelixStatesItsPitchAndItsHand) {
  using namespace glissade::test;
  const PlacedBody boss = Parts::placed(blockMesh(0.0044, 0.03, 0.03, -0.04, -0.002));
  for (const auto& [pitch, starts] : {std::pair(0.0015, 1), std::pair(-0.0015, 1), std::pair(0.0009, 1),
                                      std::pair(0.0037, 1), std::pair(0.003, 2), std::pair(-0.009, 6)}) {
    const PlacedBody shaft =
        Parts::placed(groovedShaft(helix(0.005, 0.004, pitch, starts), 0.02, 0.005, ShaftHead::None, 240));
    const std::vector<CommonThread> threads = commonThreads({shaft, boss, 0.0006});
    ASSERT_EQ(threads.size(), 1U) << pitch;
    EXPECT_NEAR(threads[0].pitch, pitch, 0.01 * std::abs(pitch));
    EXPECT_NEAR(threads[0].radius, 0.005, 1e-9);
    EXPECT_TRUE(pulledThread(threads, turned(0.025 / std::abs(pitch), std::abs(pitch), 16)).empty());
  }
}

/// A ring of vertices of a head that is sunk into its hole: some pitch suits a few of them by chance.
TEST(PulledThread, AFewVerticesAreNoHelix) {
  using namespace glissade::test;
  RandomStream random(11, "crests");
  for (int round = 0; round < 200; ++round) {
    const RoundFace wall{Vector3::Zero(), Vector3::UnitZ(), 0.0044, false, -0.02, 0.0};
    TriangleMesh mesh;
    const int count = 8 + round % 12;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * kHalfTurn * (i + random.uniform(0.0, 0.9)) / count;
      mesh.vertices.emplace_back(0.005 * std::cos(angle), 0.005 * std::sin(angle), random.uniform(-0.01, -0.002));
    }
    EXPECT_FALSE(crestsInto(wall, mesh)) << round;
  }
}

/// A stop ends the search.
TEST(PulledThread, ManyCrestsStateThePitchOfAFew) {
  using namespace glissade::test;
  const RoundFace wall{Vector3::Zero(), Vector3::UnitZ(), 0.0044, false, -0.02, 0.0};
  for (const int directions : {60, 1440}) {
    const TriangleMesh shaft = groovedShaft(helix(0.005, 0.004, 0.0015), 0.02, 0.005, ShaftHead::None, directions);
    const auto crests = crestsInto(wall, shaft);
    ASSERT_TRUE(crests) << directions;
    EXPECT_NEAR(crests->lead, 0.0015, 1e-5) << directions;
    StopSource source;
    source.requestStop();
    EXPECT_FALSE(crestsInto(wall, shaft, source.token())) << directions;
  }
}

/// Helices by their formula, and crests that are none: at random, on rims at random heights, along the axis.
TEST(CrestHelix, IsFoundWhereItIsAndNowhereElse) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  RandomStream random(51, "crest helix");
  const auto sorted = [](std::vector<Around> crests) {
    std::sort(crests.begin(), crests.end(), [](const Around& a, const Around& b) { return a.height < b.height; });
    return crests;
  };
  for (int round = 0; round < 120; ++round) {
    const double diameter = random.uniform(0.002, 0.2);
    const int starts = 1 + round % kMostStarts;
    const double lead = (round % 2 == 0 ? 1.0 : -1.0) * diameter * random.uniform(0.06, 0.19) * starts;
    const double length = 2.5 * std::abs(lead);
    const int inTurn = 12 + round % 36;
    std::vector<Around> helix;
    for (int start = 0; start < starts; ++start) {
      for (int i = 0; i < static_cast<int>(2.5 * inTurn); ++i) {
        const double turn = (i + 0.3) / inTurn;
        const double height = std::abs(lead) * (turn - static_cast<double>(start) / starts);
        helix.push_back({0.5 * diameter, height, std::remainder(kTurn * (lead < 0.0 ? -turn : turn), kTurn)});
      }
    }
    const auto found = helixOf(sorted(helix), diameter);
    ASSERT_TRUE(found) << round << ": " << starts << " starts, " << lead / diameter << " diameters";
    EXPECT_EQ(found->starts, starts) << round;
    EXPECT_NEAR(found->lead, lead, 0.01 * std::abs(lead)) << round;
    std::vector<Around> scattered;
    std::vector<Around> rims;
    std::vector<Around> teeth;
    for (int i = 0; i < 400; ++i) {
      const double anywhere = random.uniform(0.0, length);
      const double angle = random.uniform(-0.5 * kTurn, 0.5 * kTurn);
      scattered.push_back({0.5 * diameter, anywhere, angle});
      teeth.push_back({0.5 * diameter, anywhere, kTurn * (i % (8 + round % 20)) / (8 + round % 20)});
      if (i % 20 != 0) continue;
      for (int k = 0; k < inTurn; ++k) rims.push_back({0.5 * diameter, anywhere, angle + kTurn * k / inTurn});
    }
    EXPECT_FALSE(helixOf(sorted(scattered), diameter)) << round;
    EXPECT_FALSE(helixOf(sorted(rims), diameter)) << round;
    EXPECT_FALSE(helixOf(sorted(teeth), diameter)) << round;
  }
}

/// A plain neck in a cap with a modelled thread.
TEST(PulledThread, AHelixInTheHoleIsAThread) {
  using namespace glissade::test;
  const Relief inside = helix(0.0042, 0.0052, 0.0015);
  std::vector<Station> stations{{-0.02, circle(0.008)}, {-0.004, circle(0.008)}};
  for (int i = 0; i <= 160; ++i) {
    const double z = -0.004 - 0.0001 * i;
    stations.push_back({z, [inside, z](double angle) { return inside(z, angle); }});
  }
  const PlacedBody cap = Parts::placed(turnedMesh(stations, true));
  const PlacedBody neck = Parts::placed(rodMesh(0.0048, -0.03, 0.0));
  EXPECT_FALSE(pulledThread(commonThreads({cap, neck, 0.0006}), turned(0.0)).empty());
  EXPECT_FALSE(pulledThread(commonThreads({neck, cap, 0.0006}), turned(0.0)).empty());
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
  EXPECT_TRUE(pulledThread(commonThreads({around, bolt, 0.0008}), path).empty())
      << "free after the length of the hole that it is in";
}

}  // namespace
}  // namespace glissade::check
