// Tests that screws with a name, in bodies that are drawn without a hole for them, are found, planned and judged
// without hand-made joints.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/evidence/named_screw.h"
#include "engine/files/judged_product.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/fits/turned_parts.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using namespace glissade::test;

/// A body with faces of a CAD file and this deflection, metres: a cylinder of this radius about z, and the rest.
RigidBody faceOf(const std::string& name, TriangleMesh mesh, double deflection, double radius = 0.0) {
  SurfaceFace face;
  face.deflection = deflection;
  mesh.faces.push_back(face);
  face.kind = SurfaceFace::Kind::Cylinder;
  face.radius = radius;
  mesh.faces.push_back(face);
  for (const TriangleIndices& triangle : mesh.triangles) {
    const bool isOn = radius > 0.0 && std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t i) {
                        return std::abs(mesh.vertices[i].head<2>().norm() - radius) < 1e-9;
                      });
    mesh.faceOf.push_back(isOn ? 1 : 0);
  }
  RigidBody body = boxBody(name, {1.0, 1.0, 1.0}, Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A solid motor below a cap with a clearance hole, and a screw M4x10 through the cap. `cap`: metres from the head to
/// the motor; below 0 the head is in the motor.
AssembledProduct cappedMotor(const std::string& name, double cap = 0.004) {
  constexpr double kOff = 2.5e-6;  // for a circle of 2 mm with 72 corners: 1.9 micrometres
  return productOf(
      {faceOf("motor",
              turnedMesh({{-0.04, circle(0.0)}, {-0.04, prism(0.04, 4)}, {-cap, prism(0.04, 4)}, {-cap, circle(0.0)}},
                         false),
              kOff),
       faceOf("cap", plateMesh(0.0023, 0.03, -0.004, 0.0), kOff), faceOf(name, capScrew(0.004, 0.01), kOff, 0.002)},
      true);
}

AssemblyPlan planOf(const AssembledProduct& product) {
  QuietHost host;
  SequenceRequest request{BodySet(product.bodies.size(), false)};
  request.staying[0] = true;
  auto plan = planSequence(product, fitsOf(product), request, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

TEST(ScrewHolePlan, AScrewWithANameTurnsOutOfASolidBodyAndTheJudgeAgrees) {
  const AssembledProduct product = cappedMotor("DIN 912 M4x10");
  const AssemblyPlan plan = planOf(product);
  ASSERT_EQ(orderOf(plan), (std::vector<BodyId>{"DIN 912 M4x10", "cap"}));
  EXPECT_EQ(plan.steps[0].only().method, kTurned);
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt, {});
  EXPECT_TRUE(verdict.valid());
  EXPECT_TRUE(std::any_of(verdict.steps[0].allowances.begin(), verdict.steps[0].allowances.end(),
                          [](const check::AppliedAllowance& each) { return each.screwHole; }));
}

TEST(ScrewHolePlan, TheJudgeLetsNobodyPullIt) {
  const AssembledProduct product = cappedMotor("DIN 912 M4x10");
  AssemblyPlan plan = planOf(product);
  ASSERT_EQ(plan.steps.size(), 2U);
  std::vector<PathPoint>& path = plan.steps[0].only().path;
  path = {path.front(), path.back()};
  path.back().q.orientation = path.front().q.orientation;
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt, {});
  EXPECT_FALSE(verdict.steps[0].refusals.empty()) << "pulled off the motor without a turn";
}

/// Screws of another size, without a screw's name, or with the head in the motor: there is no evidence that they make a
/// hole.
TEST(ScrewHolePlan, NothingElseMakesAHole) {
  for (const AssembledProduct& product : {cappedMotor("post"), cappedMotor("DIN 912 M8x10"), cappedMotor("washer M4"),
                                          cappedMotor("DIN 912 M4x10", -0.0005)}) {
    EXPECT_TRUE(planOf(product).steps.empty()) << product.bodies[2].id;
  }
}

/// The wall of a slot with ribs: `tip` is the radius at the ribs, which are at these angles, radians.
Contour ribbed(double wall, double tip, const std::vector<double>& ribs) {
  return [=](double angle) {
    const bool isRib = std::any_of(ribs.begin(), ribs.end(), [&](double rib) {
      return std::abs(std::remainder(angle - rib, 2.0 * kHalfTurn)) < 0.15;
    });
    return isRib ? tip : wall;
  };
}

/// A profile whose slot has ribs for a screw of 3.5 mm, a cap, and a screw through the cap.
AssembledProduct cappedProfile(const std::string& name, double tip = 0.00146,
                               const std::vector<double>& ribs = {0.0, 2.1, 4.2}) {
  constexpr double kOff = 2.5e-6;
  constexpr double kWall = 0.00178;
  return productOf(
      {faceOf("profile", tubeMesh(ribbed(kWall, tip, ribs), prism(0.03, 4), -0.03, -0.004), kOff, kWall),
       faceOf("cap", plateMesh(0.002, 0.03, -0.004, 0.0), kOff), faceOf(name, capScrew(0.0035, 0.012), kOff, 0.00175)},
      true);
}

/// True if the last body forms its thread in the first one.
bool formsThread(const AssembledProduct& product) {
  const auto measured = [](const RigidBody& body) {
    return evidence::Body{body.id, body.shown(), body.mesh, body.X_WB};
  };
  const evidence::Body screw = measured(product.bodies.back());
  const evidence::Body host = measured(product.bodies.front());
  evidence::PlacedBodies placed;
  return evidence::screwInSolid({screw, screw.X_WB}, {host, host.X_WB}, placed, {}).has_value();
}

TEST(ScrewHolePlan, AScrewFormsItsThreadInTheRibsOfASlot) {
  const AssembledProduct product = cappedProfile("black screw");
  AssemblyPlan plan = planOf(product);
  ASSERT_EQ(orderOf(plan), (std::vector<BodyId>{"black screw", "cap"}));
  EXPECT_EQ(plan.steps[0].only().method, kTurned);
  EXPECT_TRUE(formsThread(product));
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt, {});
  EXPECT_TRUE(verdict.valid());
  std::vector<PathPoint>& path = plan.steps[0].only().path;
  path = {path.front(), path.back()};
  path.back().q.orientation = path.front().q.orientation;
  EXPECT_FALSE(judgePlan(plan, product, std::nullopt, {}).steps[0].refusals.empty()) << "pulled without a turn";
}

/// A name that says no screw, ribs that are deeper than a thread, and ribs on one side that the shaft would leave.
TEST(ScrewHolePlan, NoOtherShaftFormsAThread) {
  EXPECT_FALSE(formsThread(cappedProfile("screw cap")));
  EXPECT_FALSE(formsThread(cappedProfile("post")));
  EXPECT_FALSE(formsThread(cappedProfile("black screw", 0.001)));
  EXPECT_FALSE(formsThread(cappedProfile("ST3.5x12", 0.001)));
  EXPECT_FALSE(formsThread(cappedProfile("M8 screw")));
  EXPECT_FALSE(formsThread(cappedProfile("black screw", 0.00146, {0.0, 0.7, 1.4})));
}

TEST(ScrewHolePlan, TheJudgeReadsSizesOfScrewsByItself) {
  const double inch = 25.4;
  for (const auto& [name, millimetres] :
       {std::pair("DIN 912 M4x10 1", 4.0), std::pair("ISO 7049 ST4.2x35", 4.2),
        std::pair("SHCS 1_4-20 x 1", 0.25 * inch), std::pair("#10-32 BHCS", 0.19 * inch),
        std::pair("wood screw 5x40", 5.0), std::pair("M2.5 x 6", 2.5)}) {
    const auto size = evidence::screwSizeIn(name);
    ASSERT_TRUE(size) << name;
    EXPECT_NEAR(1e3 * *size, millimetres, 1e-6) << name;
  }
  for (const char* name : {"motor", "ISO 4032 M10", "hex nut M4x10", "plate 4x40", "M4 standoff", ""}) {
    EXPECT_FALSE(evidence::screwSizeIn(name)) << name;
  }
}

}  // namespace
}  // namespace glissade
