// A screw with a modelled thread in a nut that is drawn with the core diameter: the pair comes apart by turning, and
// the judge confirms nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random_stream.h"
#include "engine/base/thread_team.h"
#include "engine/check/thread_core_fit.h"
#include "engine/product/fit_table.h"
#include "tests/engine/product/turned_parts.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

constexpr double kCrest = 0.0025;
constexpr double kRoot = 0.00198;
constexpr double kBore = 0.00207;
constexpr double kScrewPitch = 0.0008;
constexpr double kThreadLength = 0.008;
constexpr int kDirections = 36;

/// Flat crests and roots of an eighth of the pitch on either side of their middle.
double threadRadius(double z, double angle) {
  const double turn = z / kScrewPitch - angle / (2.0 * test::kHalfTurn);
  const double fromCrest = std::abs(turn - std::round(turn));
  const double down = std::clamp((fromCrest - 0.125) / 0.25, 0.0, 1.0);
  return kCrest + (kRoot - kCrest) * down;
}

/// As a CAD file has them: crest, root and shank are cylinders; flanks, tip and head are faces of their own.
void stateFaces(TriangleMesh& mesh, double shank) {
  enum Face : std::uint32_t { Flanks, Crest, Root, Shank, Tip, Head };
  mesh.faces.assign(6, SurfaceFace{});
  for (const auto& [face, radius] : {std::pair(Crest, kCrest), std::pair(Root, kRoot), std::pair(Shank, kCrest)}) {
    mesh.faces[face].kind = SurfaceFace::Kind::Cylinder;
    mesh.faces[face].radius = radius;
  }
  for (const TriangleIndices& triangle : mesh.triangles) {
    const auto all = [&](const auto& is) {
      return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) { return is(mesh.vertices[v]); });
    };
    const auto isAt = [&](double radius) {
      return all([=](const Vector3& p) { return std::abs(p.head<2>().norm() - radius) < 1e-9; });
    };
    const bool isTip = all([](const Vector3& p) { return p.z() < -kThreadLength + 1e-9; });
    const bool isHead = all([](const Vector3& p) { return p.z() > -1e-9; });
    const bool isShank = shank > 0.0 && all([=](const Vector3& p) { return p.z() > -shank - 1e-9; });
    mesh.faceOf.push_back(isTip          ? Tip
                          : isHead       ? Head
                          : isShank      ? Shank
                          : isAt(kCrest) ? Crest
                          : isAt(kRoot)  ? Root
                                         : Flanks);
  }
}

/// Its head's lower side is at 0; without a thread for the length of the shank.
TriangleMesh modelledScrew(double shank = 0.0) {
  std::vector<test::Station> stations{{-kThreadLength, test::circle(0.0)}};
  for (double z = -kThreadLength; z < -shank - 1e-9; z += kScrewPitch / 8.0) {
    stations.push_back({z, [z](double angle) { return threadRadius(z, angle); }});
  }
  stations.push_back({-shank, test::circle(kCrest)});
  if (shank > 0.0) stations.push_back({0.0, test::circle(kCrest)});
  stations.push_back({0.0, test::circle(0.0045)});
  stations.push_back({0.003, test::circle(0.0045)});
  stations.push_back({0.003, test::circle(0.0)});
  TriangleMesh mesh = test::turnedMesh(stations, false, kDirections);
  stateFaces(mesh, shank);
  return mesh;
}

RigidBody partOf(const std::string& id, TriangleMesh mesh) {
  RigidBody body = boxBody(id, {1.0, 1.0, 1.0}, Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A nut of 4 mm whose wall is less than five overlaps thick, on the end of the screw.
AssembledProduct screwInNut(double shank = 0.0, double bore = kBore) {
  TriangleMesh nut = test::tubeMesh(test::circle(bore), test::prism(0.008, 6), -0.0075, -0.0035);
  return test::productOf({partOf("screw", modelledScrew(shank)), partOf("nut", std::move(nut))}, true);
}

FitTable tableOf(const AssembledProduct& product) {
  ThreadTeam team(0);
  auto table = FitTable::find(product, team, WorkWatch{});
  return std::move(*table);
}

TEST(ThreadCore, TheScrewIsItsCoreInTheNutWhicheverOfThemMoves) {
  const AssembledProduct product = screwInNut();
  const FitTable table = tableOf(product);
  ASSERT_EQ(table.pairs().size(), 1U);
  EXPECT_EQ(table.pairs()[0].contact.kind, ContactKind::Thread);
  for (const PairWay& way : table.pairs()[0].ways) {
    ASSERT_EQ(way.taken.size(), 1U) << way.refused;
    const Fit& fit = way.taken[0];
    EXPECT_TRUE(fit.core);
    ASSERT_TRUE(fit.thread);
    EXPECT_NEAR(fit.thread->rule.pitch, kScrewPitch, 1e-9);
    EXPECT_NEAR(fit.allowance, kCrest - kBore, 3e-5);
  }
}

/// Rays from the outside count the crossings of the true surface; they share nothing with the thinning.
TEST(ThreadCore, TheCoreIsInsideTheScrewAndFreesTheThreadOnly) {
  const AssembledProduct product = screwInNut();
  const FitTable table = tableOf(product);
  const TriangleMesh& core = *table.objects()[0].allowed.at(0).thinned;
  const TriangleMesh& screw = *product.bodies[0].mesh;
  const AxialMesh isTrue(screw);
  const AxialMesh isCore(core);
  const Box3 box = boundingBox(screw);
  RandomStream random(7, "points");
  int freed = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 p(random.uniform(box.min().x(), box.max().x()), random.uniform(box.min().y(), box.max().y()),
                    random.uniform(box.min().z(), box.max().z()));
    const bool wasIn = isTrue.contains(p);
    if (isCore.contains(p)) {
      EXPECT_TRUE(wasIn) << p.transpose();
    } else if (wasIn) {
      ++freed;
      EXPECT_GT(p.head<2>().norm(), 0.99 * kRoot) << "only teeth go: " << p.transpose();
    }
  }
  EXPECT_GT(freed, 100);
}

/// A collar that is pressed into a groove has no helix.
TEST(ThreadCore, ADeepOverlapWithoutAHelixStaysAClash) {
  TriangleMesh pin = test::rodMesh(kCrest, -kThreadLength, 0.0);
  TriangleMesh nut = test::tubeMesh(test::circle(0.0019), test::circle(0.0031), -0.0075, -0.0035);
  const FitTable table =
      tableOf(test::productOf({partOf("pin", std::move(pin)), partOf("ring", std::move(nut))}, true));
  for (const PairFit& pair : table.pairs()) {
    for (const PairWay& way : pair.ways) {
      for (const Fit& fit : way.taken) EXPECT_FALSE(fit.core);
    }
  }
}

TEST(ThreadCore, NoThreadIsDeeperThanASharpOne) {
  EXPECT_TRUE(check::isThreadDepth({0.0025, 0.00207, 0.0008}));
  EXPECT_TRUE(check::isThreadDepth({0.0025, 0.00207, -0.0008}));
  EXPECT_FALSE(check::isThreadDepth({0.0025, 0.00207, 0.0004}));
  EXPECT_FALSE(check::isThreadDepth({0.0025, 0.0015, 0.002})) << "more than 0.15 of the diameter";
  EXPECT_FALSE(check::isThreadDepth({0.0025, 0.0025, 0.0008})) << "no overlap";
}

}  // namespace
}  // namespace glissade
