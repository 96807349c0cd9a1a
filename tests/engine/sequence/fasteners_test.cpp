#include "engine/sequence/fasteners.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/import/step_import.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/sequence/products.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

constexpr std::size_t kSegments = 24;

/// A ring with a prism of `sides` sides as its outside; `corner`: radius of the corners.
TriangleMesh prismRing(double inner, double corner, double length, int sides) {
  TriangleMesh mesh = test::makeRing(inner, corner, length, kSegments);
  const double side = 2.0 * 3.14159265358979323846 / sides;
  for (std::size_t i = 0; i < 2 * kSegments; ++i) {
    Vector3& vertex = mesh.vertices[i];
    const double angle = std::atan2(vertex.y(), vertex.x());
    const double within = angle - side * std::floor(angle / side + 1e-9) - 0.5 * side;
    vertex.head<2>() *= std::cos(0.5 * side) / std::cos(within);
  }
  return mesh;
}

RigidBody placed(const std::string& name, TriangleMesh mesh, const Pose& X_WB) {
  RigidBody body = boxBody(name, {1.0, 1.0, 1.0}, X_WB);
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

TriangleMesh boltMesh(double radius, double head) {
  TriangleMesh mesh = test::makeRing(0.0, radius, 0.04, kSegments);
  append(mesh, transformed(test::makeRing(0.0, head, 0.006, kSegments), Pose::translation({0.0, 0.0, -0.022})));
  return mesh;
}

/// Parts on one axis, at any pose; their names do not say what they are.
AssembledProduct fastened(const Pose& X_WF, double shaft = 0.004) {
  const auto at = [&](double z) { return X_WF * Pose::translation({0.0, 0.0, z}); };
  return test::productOf(
      {placed("1", boltMesh(shaft, 0.007), at(0.0)), placed("2", prismRing(0.004, 0.007, 0.006, 6), at(0.006)),
       placed("3", test::makeRing(0.004, 0.009, 0.0015, kSegments), at(0.00225)),
       placed("4", prismRing(0.004, 0.03, 0.0205, 4), at(-0.00875)),
       placed("5", test::makeRing(0.0, 0.002, 0.02, kSegments), at(0.0) * Pose::translation({0.015, 0.0, -0.00875})),
       placed("6", test::makeRing(0.002, 0.0035, 0.002, kSegments), at(0.0) * Pose::translation({0.015, 0.0, 0.0025}))},
      true);
}

TEST(Fasteners, AreRecognisedByShapeAndContactsInEveryDirection) {
  RandomStream random(1, "directions");
  for (int round = 0; round < 5; ++round) {
    Pose X_WF;
    X_WF.orientation =
        fromRollPitchYaw(random.uniform(-3.0, 3.0), random.uniform(-1.5, 1.5), random.uniform(-3.0, 3.0));
    const AssembledProduct product = fastened(X_WF);
    const ProductFits fits = test::fitsOf(product);
    const auto kinds = fastenersOf(ProductShapes(product), fits.contacts());
    EXPECT_EQ(kinds[0], FastenerKind::Screw);
    EXPECT_EQ(kinds[1], FastenerKind::Nut);
    EXPECT_EQ(kinds[2], FastenerKind::Washer);
    EXPECT_EQ(kinds[3], FastenerKind::None) << "a plate with a hole";
  }
}

TEST(Fasteners, NutsLeaveBeforeTheirBolts) {
  const AssembledProduct product = fastened(Pose::identity());
  const ProductFits fits = test::fitsOf(product);
  const auto kinds = fastenersOf(ProductShapes(product), fits.contacts());
  const auto rules = fastenerRules(kinds, fits.contacts());
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules[0].first, 1U);
  EXPECT_EQ(rules[0].then, 0U);
  EXPECT_FALSE(rules[0].demanded);
  MotionTrial trial(product, fits, 1, 0);
  test::QuietHost host;
  BodySet staying(product.bodies.size(), false);
  staying[3] = true;
  const AssemblyPlan plan = makeSequenceStrategyRegistry().find("greedy")->make()->plan(
      {product, staying, 1, trial, nullptr, {{}, rules}, kinds}, host);
  const auto order = test::orderOf(plan);
  const auto nut = std::find(order.begin(), order.end(), "2");
  const auto bolt = std::find(order.begin(), order.end(), "1");
  ASSERT_NE(nut, order.end());
  ASSERT_NE(bolt, order.end());
  EXPECT_LT(nut, bolt);
  const auto& step = plan.steps[static_cast<std::size_t>(bolt - order.begin())];
  EXPECT_EQ(step.only().fastener, FastenerKind::Screw);
  const auto number = static_cast<std::size_t>(nut - order.begin()) + 1;
  EXPECT_NE(std::find(step.after.begin(), step.after.end(), number), step.after.end());
}

/// Rectangular nuts as in as1: a box with a hole, which only its name distinguishes from a plate.
TEST(Fasteners, ANutMayBeARectangle) {
  for (const auto& [name, width] : {std::pair("nut", 0.016), std::pair("nut", 0.02), std::pair("plate", 0.02)}) {
    TriangleMesh nut = prismRing(0.004, 0.02, 0.006, 4);
    for (std::size_t i = 0; i < 2 * kSegments; ++i) {
      const Vector3 corner = fromRollPitchYaw(0.0, 0.0, 0.25 * 3.14159265358979323846) * nut.vertices[i];
      nut.vertices[i] = {corner.x() * width / 0.0283, corner.y() * 0.012 / 0.0283, corner.z()};
    }
    const AssembledProduct product =
        test::productOf({placed("1", boltMesh(0.004, 0.007), Pose::identity()),
                         placed(name, std::move(nut), Pose::translation({0.0, 0.0, 0.006}))},
                        true);
    const auto kinds = fastenersOf(ProductShapes(product), test::fitsOf(product).contacts());
    EXPECT_EQ(kinds[1], std::string(name) == "nut" ? FastenerKind::Nut : FastenerKind::None) << width;
  }
}

TEST(Fasteners, ShapeAloneIsNotEnough) {
  const AssembledProduct product = fastened(Pose::identity());
  const auto kinds = fastenersOf(ProductShapes(product), {});
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), FastenerKind::None), static_cast<std::ptrdiff_t>(kinds.size()));
}

/// Only the cone of the screw touches the part, and not its shaft.
TEST(Fasteners, ACountersunkScrewIsOneByItsCone) {
  const auto file = importStep(test::stepFile("round-fits.step"), 0.0);
  ASSERT_TRUE(file);
  std::vector<RigidBody> bodies;
  std::vector<ContactBody> asBodies;
  for (const Occurrence& part : file->parts) {
    bodies.push_back(placed(part.path, *part.mesh, part.X_FP));
    asBodies.push_back({BodyId(part.path), part.mesh, part.X_FP, part.deflection});
  }
  const AssembledProduct product = test::productOf(std::move(bodies), true);
  const auto kinds = fastenersOf(ProductShapes(product), findContacts(asBodies).contacts);
  ASSERT_EQ(product.bodies[1].id, "seated");
  EXPECT_EQ(kinds[1], FastenerKind::Screw);
  const auto head = headOf(*product.bodies[1].mesh);
  ASSERT_TRUE(head);
  EXPECT_NEAR(head->height, 2e-3, 4e-4) << "the cone, but where it is hardly wider than the shaft";
  EXPECT_NEAR(head->shaft, 2e-3, 1e-6);
  EXPECT_NEAR(head->radius, 4e-3, 1e-6);
  EXPECT_GT(head->outwards.z(), 0.999);
  EXPECT_NEAR((product.bodies[1].X_WB * head->end).z(), 6e-3, 1e-6);
}

/// A screw whose thread is in no body of the file touches what its head lies on, by a plane only.
TEST(Fasteners, AScrewByItsNameNeedsNoHole) {
  const auto kindOf = [](const std::string& name) {
    const AssembledProduct product =
        test::productOf({placed(name, boltMesh(0.004, 0.007), Pose::identity()),
                         placed("plate", prismRing(0.006, 0.03, 0.01, 4), Pose::translation({0.0, 0.0, -0.014}))},
                        true);
    const ProductFits fits = test::fitsOf(product);
    return fastenersOf(ProductShapes(product), fits.contacts()).front();
  };
  EXPECT_EQ(kindOf("M8x40 SHCS"), FastenerKind::Screw);
  EXPECT_EQ(kindOf("part"), FastenerKind::None);
}

}  // namespace
}  // namespace glissade
