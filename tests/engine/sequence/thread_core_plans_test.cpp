// A screw with a modelled thread in a nut that is drawn with the core diameter: the pair comes apart by turning, and
// the judge confirms nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random_stream.h"
#include "engine/base/thread_team.h"
#include "engine/check/thread_core_fit.h"
#include "engine/product/fit_table.h"
#include "engine/scenario/judged_product.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/product/turned_parts.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

constexpr double kCrest = 0.0025;
constexpr double kRoot = 0.00198;
constexpr double kBore = 0.00207;
constexpr double kPitch = 0.0008;
constexpr double kLength = 0.008;
constexpr int kDirections = 36;

/// Flat crests and roots of an eighth of the pitch on either side of their middle.
double threadRadius(double z, double angle) {
  const double turn = z / kPitch - angle / (2.0 * test::kHalfTurn);
  const double fromCrest = std::abs(turn - std::round(turn));
  const double down = std::clamp((fromCrest - 0.125) / 0.25, 0.0, 1.0);
  return kCrest + (kRoot - kCrest) * down;
}

/// As a CAD file has them: crest and root are cylinders, all else are free faces.
void stateFaces(TriangleMesh& mesh) {
  mesh.faces = {SurfaceFace{}, SurfaceFace{}, SurfaceFace{}};
  for (const int face : {1, 2}) {
    mesh.faces[face].kind = SurfaceFace::Kind::Cylinder;
    mesh.faces[face].radius = face == 1 ? kCrest : kRoot;
  }
  for (const TriangleIndices& triangle : mesh.triangles) {
    const auto isAt = [&](double radius) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](std::uint32_t v) { return std::abs(mesh.vertices[v].head<2>().norm() - radius) < 1e-9; });
    };
    const bool isSide = std::abs(faceNormal(mesh, triangle).z()) < 0.5;
    mesh.faceOf.push_back(isSide && isAt(kCrest) ? 1 : isSide && isAt(kRoot) ? 2 : 0);
  }
}

/// Its head's lower side is at 0; without a thread for the length of the shank.
TriangleMesh threadedScrew(double shank = 0.0) {
  std::vector<test::Station> stations{{-kLength, test::circle(0.0)}};
  for (double z = -kLength; z < -shank - 1e-9; z += kPitch / 8.0) {
    stations.push_back({z, [z](double angle) { return threadRadius(z, angle); }});
  }
  stations.push_back({-shank, test::circle(kCrest)});
  if (shank > 0.0) stations.push_back({0.0, test::circle(kCrest)});
  stations.push_back({0.0, test::circle(0.0045)});
  stations.push_back({0.003, test::circle(0.0045)});
  stations.push_back({0.003, test::circle(0.0)});
  TriangleMesh mesh = test::turnedMesh(stations, false, kDirections);
  stateFaces(mesh);
  return mesh;
}

RigidBody bodyOf(const std::string& id, TriangleMesh mesh) {
  RigidBody body = boxBody(id, {1.0, 1.0, 1.0}, Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A nut of 4 mm whose wall is less than five overlaps thick, on the end of the screw.
AssembledProduct screwInNut(double shank = 0.0, double bore = kBore) {
  TriangleMesh nut = test::tubeMesh(test::circle(bore), test::prism(0.008, 6), -0.0075, -0.0035);
  return test::productOf({bodyOf("screw", threadedScrew(shank)), bodyOf("nut", std::move(nut))}, true);
}

FitTable fitsOf(const AssembledProduct& product) {
  ThreadTeam team(0);
  return std::move(*FitTable::find(product, team, WorkWatch{}));
}

AssemblyPlan planOf(const AssembledProduct& product) {
  test::QuietHost host;
  auto plan = planSequence(product, test::fitsOf(product), SequenceRequest{BodySet{true, false}}, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

check::PlanVerdict verdictOf(const AssemblyPlan& plan, const AssembledProduct& product) {
  return judgePlan(plan, product, std::nullopt, {});
}

TEST(ThreadCore, TheScrewIsItsCoreInTheNutWhicheverOfThemMoves) {
  const AssembledProduct product = screwInNut();
  const FitTable table = fitsOf(product);
  ASSERT_EQ(table.pairs().size(), 1U);
  EXPECT_EQ(table.pairs()[0].contact.kind, ContactKind::Thread);
  for (const PairWay& way : table.pairs()[0].ways) {
    ASSERT_EQ(way.taken.size(), 1U) << way.refused;
    const Fit& fit = way.taken[0];
    EXPECT_TRUE(fit.core);
    ASSERT_TRUE(fit.thread);
    EXPECT_NEAR(fit.thread->rule.pitch, kPitch, 1e-9);
    EXPECT_NEAR(fit.allowance, kCrest - kBore, 3e-5);
  }
}

/// Rays from the outside count the crossings of the true surface; they share nothing with the thinning.
TEST(ThreadCore, TheCoreIsInsideTheScrewAndFreesTheThreadOnly) {
  const AssembledProduct product = screwInNut();
  const FitTable table = fitsOf(product);
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
      EXPECT_GT(p.head<2>().norm(), 0.99 * kRoot) << "only teeth go";
    }
  }
  EXPECT_GT(freed, 100);
}

TEST(ThreadCore, TheNutIsTurnedOffAndTheJudgeConfirmsIt) {
  const AssembledProduct product = screwInNut();
  const AssemblyPlan plan = planOf(product);
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_EQ(plan.steps[0].method, kTurned);
  const check::PlanVerdict verdict = verdictOf(plan, product);
  EXPECT_TRUE(verdict.valid());
}

TEST(ThreadCore, TheJudgeRefusesToPullItOff) {
  const AssembledProduct product = screwInNut();
  AssemblyPlan plan = planOf(product);
  ASSERT_EQ(plan.steps.size(), 1U);
  const Quaternion turned = plan.steps[0].path.front().q.orientation;
  for (PathPoint& point : plan.steps[0].path) point.q.orientation = turned;
  EXPECT_FALSE(verdictOf(plan, product).valid());
}

TEST(ThreadCore, TheJudgeRefusesAPitchThatTheTeethAreTooDeepFor) {
  const AssembledProduct product = screwInNut();
  AssemblyPlan plan = planOf(product);
  ASSERT_FALSE(plan.steps.empty());
  for (StepAllowance& allowance : plan.steps[0].allowances) allowance.pitch = 0.0004;
  EXPECT_FALSE(verdictOf(plan, product).valid());
}

TEST(ThreadCore, AShankIsNoThread) {
  const AssembledProduct product = screwInNut(0.003);
  const AssemblyPlan plan = planOf(product);
  ASSERT_EQ(plan.steps.size(), 1U);
  EXPECT_LT(plan.steps[0].path.back().q.position.z(), plan.steps[0].path.front().q.position.z())
      << "the nut leaves over the tip";
  const FitTable table = fitsOf(product);
  const AxialMesh core(*table.objects()[0].allowed.at(0).thinned);
  const double middleOfShank = product.bodies[0].mesh->vertices[0].z() + kLength - 0.0015;
  EXPECT_TRUE(core.contains({0.99 * kCrest, 0.0, middleOfShank}));
}

/// A collar that is pressed into a groove has no helix.
TEST(ThreadCore, ADeepOverlapWithoutAHelixStaysAClash) {
  TriangleMesh pin = test::rodMesh(kCrest, -kLength, 0.0);
  TriangleMesh nut = test::tubeMesh(test::circle(0.0019), test::circle(0.0031), -0.0075, -0.0035);
  const FitTable table = fitsOf(test::productOf({bodyOf("pin", std::move(pin)), bodyOf("ring", std::move(nut))}, true));
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
