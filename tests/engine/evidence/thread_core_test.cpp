// Tests that the judge finds the thread of a shaft that a file takes away, and refuses claims that the meshes
// contradict.
#include "engine/evidence/thread_core.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/evidence/ray_containment.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/fits/threaded_screw.h"

namespace glissade::check {
namespace {

constexpr double kHole = 0.00207;

struct ScrewInNut {
  explicit ScrewInNut(const test::ThreadedScrew& screw = {}, double hole = kHole, double low = -0.0075,
                      double high = -0.0035)
      : shaft(test::checkBody("screw", screw.mesh()), tilt),
        nut(test::checkBody("nut", test::plainNut(hole, low, high)), tilt),
        claim{tilt.position, tilt.orientation * Vector3::UnitZ(), screw.pitch, screw.crest} {}

  Result<ThreadCore> core() const { return threadCoreOf(shaft, nut, claim); }

  Pose tilt{Vector3(0.1, -0.2, 0.05), fromRollPitchYaw(0.3, -0.6, 1.1)};
  PlacedBody shaft;
  PlacedBody nut;
  ClaimedThread claim;
};

std::string refusalOf(const ScrewInNut& pair) {
  const auto core = pair.core();
  return core ? std::string() : toString(core.error().reason);
}

TEST(ThreadCore, IsWhatTheHoleLeaves) {
  const ScrewInNut pair;
  const auto core = pair.core();
  ASSERT_TRUE(core.ok()) << toString(core.error().reason);
  const double apothem = kHole * std::cos(test::kHalfTurn / 72.0);
  EXPECT_LT(core->radius, apothem);
  EXPECT_GT(core->radius, apothem - 2e-5);
  EXPECT_NEAR(core->low, -0.008, 1e-4);
  EXPECT_NEAR(core->high, 0.0, 5e-4);
}

/// The ring of a lock nut has vertices at one height only; the metal part of the nut is as wide as the crests.
TEST(ThreadCore, IsWhatARingLeaves) {
  ScrewInNut pair;
  const auto outside = test::prism(0.008, 6);
  const TriangleMesh nut = test::turnedMesh({{-0.0075, test::circle(0.0025)},
                                             {-0.0075, outside},
                                             {-0.0035, outside},
                                             {-0.0035, test::circle(0.0023)},
                                             {-0.0042, test::circle(kHole)},
                                             {-0.0049, test::circle(0.0025)}},
                                            true);
  pair.nut = PlacedBody(test::checkBody("nut", nut), pair.tilt);
  EXPECT_EQ(refusalOf(pair), "");
}

TEST(ThreadCore, LeftHandedThreadsHaveAPitchBelowZero) {
  test::ThreadedScrew screw;
  screw.pitch = -screw.pitch;
  TriangleMesh mirrored = test::ThreadedScrew().mesh();
  for (Vector3& p : mirrored.vertices) p.x() = -p.x();
  for (TriangleIndices& t : mirrored.triangles) std::swap(t[0], t[1]);
  ScrewInNut pair;
  pair.shaft = PlacedBody(test::checkBody("screw", mirrored), pair.tilt);
  EXPECT_EQ(refusalOf(pair), "the shaft has no helix of the pitch that the file states");
  pair.claim.pitch = -pair.claim.pitch;
  EXPECT_EQ(refusalOf(pair), "");
}

TEST(ThreadCore, AFalseAxisIsRefused) {
  ScrewInNut aside;
  aside.claim.point += aside.tilt.orientation * Vector3(3e-5, 0.0, 0.0);
  EXPECT_NE(refusalOf(aside), "");
  ScrewInNut tilted;
  tilted.claim.axis = tilted.tilt.orientation * Vector3(0.02, 0.0, 1.0);
  EXPECT_NE(refusalOf(tilted), "");
  ScrewInNut across;
  across.claim.axis = across.tilt.orientation * Vector3::UnitX();
  EXPECT_NE(refusalOf(across), "");
  ScrewInNut none;
  none.claim.axis = Vector3::Zero();
  EXPECT_NE(refusalOf(none), "");
}

TEST(ThreadCore, AFalsePitchIsRefused) {
  for (const double share : {-1.0, 0.5, 0.9, 0.95, 1.05, 1.1, 2.0, 3.0, 1e-9, 1e9}) {
    ScrewInNut pair;
    pair.claim.pitch *= share;
    EXPECT_NE(refusalOf(pair), "") << share;
  }
}

TEST(ThreadCore, FalseCrestsAreRefused) {
  for (const double off : {-3e-4, 5e-5, 3e-4}) {
    ScrewInNut crest;
    crest.claim.crest += off;
    EXPECT_NE(refusalOf(crest), "") << off;
  }
}

TEST(ThreadCore, ABoltWhoseCoreIsWiderThanTheHoleIsRefused) {
  EXPECT_EQ(refusalOf(ScrewInNut({}, 0.0019)), "the shaft has no groove that is as narrow as the hole");
  test::ThreadedScrew shallow;
  shallow.root = 0.0022;
  EXPECT_EQ(refusalOf(ScrewInNut(shallow)), "the shaft has no groove that is as narrow as the hole");
}

/// The nut has a second, narrower hole at its end, within the length of the thread.
TEST(ThreadCore, ANarrowerPlaceOfTheHoleCounts) {
  ScrewInNut pair;
  TriangleMesh nut = test::plainNut(kHole, -0.0075, -0.0045);
  append(nut, test::plainNut(0.0019, -0.0045, -0.0035));
  pair.nut = PlacedBody(test::checkBody("nut", nut), pair.tilt);
  EXPECT_EQ(refusalOf(pair), "the shaft has no groove that is as narrow as the hole");
}

TEST(ThreadCore, APlainCylinderHasNone) {
  ScrewInNut pair;
  pair.shaft = PlacedBody(test::checkBody("pin", test::rodMesh(pair.claim.crest, -0.008, 0.0)), pair.tilt);
  EXPECT_EQ(refusalOf(pair), "the shaft has no groove that is as narrow as the hole");
}

/// Rings are no helix.
TEST(ThreadCore, GroovesWithoutAHelixAreRefused) {
  std::vector<test::Station> stations{{-0.008, test::circle(0.0)}};
  for (int i = 0; i < 10; ++i) {
    const double z = -0.008 + 0.0008 * i;
    for (const auto& [share, radius] :
         {std::pair(0.0, 0.00198), std::pair(0.25, 0.00198), std::pair(0.5, 0.0025), std::pair(0.75, 0.0025)})
      stations.push_back({z + 0.0008 * share, test::circle(radius)});
  }
  stations.push_back({0.0, test::circle(0.0025)});
  stations.push_back({0.0, test::circle(0.0)});
  ScrewInNut pair;
  pair.shaft = PlacedBody(test::checkBody("pin", test::turnedMesh(stations, false, 36)), pair.tilt);
  EXPECT_EQ(refusalOf(pair), "the shaft has no helix of the pitch that the file states");
}

TEST(ThreadCore, TeethThatAreTooDeepAreRefused) {
  test::ThreadedScrew deep;
  deep.root = 0.0016;
  EXPECT_NE(refusalOf(ScrewInNut(deep, 0.0017)), "");
}

TEST(ThreadCore, AHoleThatIsNotNarrowerThanTheCrestsHasNone) { EXPECT_NE(refusalOf(ScrewInNut({}, 0.0026)), ""); }

TEST(ThreadCore, ANutBesideTheThreadHasNone) {
  test::ThreadedScrew screw;
  screw.shank = 0.005;
  EXPECT_NE(refusalOf(ScrewInNut(screw, kHole, -0.004, -0.001)), "") << "on the shank";
  EXPECT_NE(refusalOf(ScrewInNut({}, kHole, -0.013, -0.009)), "") << "beyond the tip";
}

/// Compares points with the original screw by rays: nothing is added, and only teeth are removed.
void expectOnlyTeethGo(const test::ThreadedScrew& screw) {
  const ScrewInNut pair(screw);
  const auto core = pair.core();
  ASSERT_TRUE(core.ok()) << toString(core.error().reason);
  const TriangleMesh whole = screw.mesh();
  const RaySolid was(whole);
  const RaySolid is(withoutThread(whole, inFrame(inverse(pair.tilt), *core)));
  RandomStream random(7, "points");
  int freed = 0;
  for (int i = 0; i < 4000; ++i) {
    const double radius = random.uniform(0.0015, 0.0046);
    const double angle = random.uniform(-test::kHalfTurn, test::kHalfTurn);
    const Vector3 p(radius * std::cos(angle), radius * std::sin(angle), random.uniform(-0.009, 0.004));
    const bool wasIn = was.contains(p);
    if (is.contains(p)) {
      EXPECT_TRUE(wasIn) << p.transpose();
      const bool inNut = p.z() > -0.0075 && p.z() < -0.0035;
      EXPECT_TRUE(!inNut || p.head<2>().norm() <= core->radius + 1e-12) << p.transpose();
    } else if (wasIn) {
      ++freed;
      EXPECT_GT(p.head<2>().norm(), 0.99 * screw.root) << p.transpose();
      EXPECT_LE(p.head<2>().norm(), screw.crest + 1e-9) << p.transpose();
      EXPECT_LT(p.z(), std::min(-screw.shank, -1e-9)) << "shank and head are whole " << p.transpose();
    }
  }
  EXPECT_GT(freed, 50);
}

TEST(ThreadCore, OnlyTeethAreTakenAway) {
  expectOnlyTeethGo({});
  test::ThreadedScrew screw;
  screw.shank = 0.003;
  screw.chamfer = 0.0003;
  expectOnlyTeethGo(screw);
}

}  // namespace
}  // namespace glissade::check
