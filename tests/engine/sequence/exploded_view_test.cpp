#include "engine/sequence/exploded_view.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

Box3 explodedBox(const AssembledProduct& product, const std::vector<Vector3>& offsets, std::size_t body) {
  Box3 box = boundingBox(*product.bodies[body].mesh, product.bodies[body].X_WB);
  box.translate(offsets[body]);
  return box;
}

void expectApart(const AssembledProduct& product, const std::vector<Vector3>& offsets, const BodySet& moved) {
  for (std::size_t a = 0; a < product.bodies.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!moved[a] && !moved[b]) continue;
      const Box3 common = explodedBox(product, offsets, a).intersection(explodedBox(product, offsets, b));
      EXPECT_TRUE(common.isEmpty() || common.volume() < 1e-12)
          << product.bodies[a].id << " and " << product.bodies[b].id;
    }
  }
}

TEST(ExplodedView, BodiesThatLeaveAreApartAndTheOthersStay) {
  const AssembledProduct product = test::lockedDrawer();
  const auto offsets = explodedOffsets(product, test::planOf(product, "cabinet"));
  EXPECT_EQ(offsets[*product.indexOf("cabinet")], Vector3(Vector3::Zero()));
  expectApart(product, offsets, BodySet(product.bodies.size(), true));
  EXPECT_GT(offsets[*product.indexOf("cap")].z(), offsets[*product.indexOf("pin")].z()) << "the cap is above its pin";
}

TEST(ExplodedView, BoxesInAnyOrderAndDirectionComeApart) {
  RandomStream random(1, "exploded");
  for (int round = 0; round < 30; ++round) {
    std::vector<RigidBody> bodies;
    for (int i = 0; i < 8; ++i) {
      const Vector3 size(random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), random.uniform(0.2, 1.0));
      const Vector3 at(random.uniform(), random.uniform(), random.uniform());
      bodies.push_back(boxBody(std::to_string(i), size, Pose::translation(at)));
    }
    const AssembledProduct product = test::productOf(bodies);
    AssemblyPlan plan;
    for (int i = 1; i < 8; ++i) {
      Vector3 direction(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      if (round % 2 == 0) direction = Vector3::Unit(i % 3);
      const Pose& start = product.bodies[static_cast<std::size_t>(i)].X_WB;
      AssemblyStep step;
      step.body = std::to_string(i);
      step.path = {{start, Author::Computer},
                   {{start.position + 5.0 * direction.normalized(), start.orientation}, Author::Computer}};
      plan.steps.push_back(step);
    }
    BodySet moved(8, true);
    moved[0] = false;
    expectApart(product, explodedOffsets(product, plan), moved);
  }
}

TEST(ExplodedView, WithoutStepsNothingMoves) {
  const AssembledProduct product = test::chain();
  for (const Vector3& offset : explodedOffsets(product, {})) EXPECT_EQ(offset, Vector3(Vector3::Zero()));
}

}  // namespace
}  // namespace glissade
