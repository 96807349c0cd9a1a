#include "engine/sequence/exploded_view.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

constexpr double kTolerance = 1e-9;

Box3 explodedBox(const AssembledProduct& product, const std::vector<Pose>& moved, std::size_t body) {
  return boundingBox(*product.bodies[body].mesh, moved[body] * product.bodies[body].X_WB);
}

void expectApart(const AssembledProduct& product, const std::vector<Pose>& moved, const BodySet& leaves) {
  for (std::size_t a = 0; a < product.bodies.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!leaves[a] && !leaves[b]) continue;
      const Box3 common = explodedBox(product, moved, a).intersection(explodedBox(product, moved, b));
      EXPECT_TRUE(common.isEmpty() || common.volume() < 1e-12)
          << product.bodies[a].id << " and " << product.bodies[b].id;
    }
  }
}

/// Depth of the overlap of two boxes: the smallest displacement along an axis that separates them.
double depthOf(const Box3& a, const Box3& b) {
  const Vector3 common = a.max().cwiseMin(b.max()) - a.min().cwiseMax(b.min());
  return std::max(0.0, common.minCoeff());
}

/// The boxes of which a test's body consists, at its pose. Independent oracle: it knows how the bodies were made, and
/// uses no collision query. Precondition: the body has not turned.
std::vector<Box3> piecesOf(const RigidBody& body, const Pose& moved) {
  constexpr std::size_t kCorners = 8;
  EXPECT_LT(angleBetween(moved.orientation, Quaternion::Identity()), kTolerance);
  std::vector<Box3> pieces;
  for (std::size_t first = 0; first < body.mesh->vertices.size(); first += kCorners) {
    Box3 piece;
    for (std::size_t i = 0; i < kCorners; ++i) piece.extend(moved * (body.X_WB * body.mesh->vertices[first + i]));
    pieces.push_back(piece);
  }
  return pieces;
}

double depthOf(const AssembledProduct& product, const std::vector<Pose>& moved, std::size_t a, std::size_t b) {
  double deepest = 0.0;
  for (const Box3& one : piecesOf(product.bodies[a], moved[a])) {
    for (const Box3& other : piecesOf(product.bodies[b], moved[b])) deepest = std::max(deepest, depthOf(one, other));
  }
  return deepest;
}

/// No two bodies overlap more at any sampled share than they do in the assembled product.
void expectNoMoreOverlapThanAtRest(const AssembledProduct& product, const ExplodedView& view) {
  constexpr int kSamples = 300;
  const auto rest = view.at(0.0);
  for (int sample = 0; sample <= kSamples; ++sample) {
    const auto moved = view.at(static_cast<double>(sample) / kSamples);
    for (std::size_t a = 0; a < product.bodies.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        ASSERT_LE(depthOf(product, moved, a, b), depthOf(product, rest, a, b) + kTolerance)
            << product.bodies[a].id << " and " << product.bodies[b].id << " at " << sample;
      }
    }
  }
}

TEST(ExplodedView, BodiesThatLeaveAreApartAndTheOthersStay) {
  const AssembledProduct product = test::lockedDrawer();
  const auto moved = ExplodedView(product, test::planOf(product, "cabinet")).at(1.0);
  EXPECT_EQ(moved[product.indexOf("cabinet")], Pose::identity());
  expectApart(product, moved, BodySet(product.bodies.size(), true));
  EXPECT_GT(moved[product.indexOf("cap")].position.z(), moved[product.indexOf("pin")].position.z())
      << "the cap is above its pin";
}

TEST(ExplodedView, NoBodyIsDrivenThroughAnother) {
  const AssembledProduct drawer = test::lockedDrawer();
  expectNoMoreOverlapThanAtRest(drawer, ExplodedView(drawer, test::planOf(drawer, "cabinet")));
  // Plates on a peg, and a pin across them.
  const AssembledProduct stack = test::productOf({boxBody("base", {1.0, 1.0, 0.1}, Pose::identity()),
                                                  boxBody("a", {0.8, 0.8, 0.1}, Pose::translation({0, 0, 0.1})),
                                                  boxBody("b", {0.6, 0.6, 0.1}, Pose::translation({0, 0, 0.2})),
                                                  boxBody("c", {0.9, 0.9, 0.1}, Pose::translation({0, 0, 0.3}))});
  expectNoMoreOverlapThanAtRest(stack, ExplodedView(stack, test::planOf(stack, "base")));
}

TEST(ExplodedView, OneStepMovesAtATimeAndTheLastShareHasAll) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  const ExplodedView view(product, plan);
  const std::size_t first = product.indexOf(plan.steps.front().only().body);
  const std::size_t last = product.indexOf(plan.steps.back().only().body);
  const auto early = view.at(0.3);
  EXPECT_GT(early[first].position.norm(), 0.0);
  EXPECT_EQ(early[last], Pose::identity());
  EXPECT_GT(view.at(1.0)[last].position.norm(), 0.0);
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
      AssemblyStep step{{StepMotion()}};
      step.only().body = BodyId(std::to_string(i));
      step.only().path = {{start, Author::Computer},
                          {{start.position + 5.0 * direction.normalized(), start.orientation}, Author::Computer}};
      plan.steps.push_back(step);
    }
    BodySet leaves(8, true);
    leaves[0] = false;
    expectApart(product, ExplodedView(product, plan).at(1.0), leaves);
  }
}

/// Blocks side by side that leave upwards; `turns`: turned out like screws, with a configuration every 0.8 radians.
std::pair<AssembledProduct, AssemblyPlan> blocksThatLeave(int count, bool turns) {
  const auto mesh = std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(0.01)));
  std::pair<AssembledProduct, AssemblyPlan> made;
  auto& [product, plan] = made;
  for (int i = 0; i < count; ++i) {
    RigidBody body;
    body.id = BodyId("block" + std::to_string(i));
    body.mesh = mesh;
    body.X_WB = Pose::translation({0.011 * (i % 20), 0.011 * std::floor(i / 20.0), 0.0});
    product.bodies.push_back(body);
  }
  for (int i = count - 1; i > 0; --i) {
    AssemblyStep step{{StepMotion()}};
    step.only().body = product.bodies[static_cast<std::size_t>(i)].id;
    const int edges = turns ? 80 : 1;
    for (int edge = 0; edge <= edges; ++edge) {
      Pose q = product.bodies[static_cast<std::size_t>(i)].X_WB;
      q.position.z() += 0.4 * edge / edges;
      q.orientation = fromRotationVector((turns ? 0.8 * edge : 0.0) * Vector3::UnitZ());
      step.only().path.push_back({q, Author::Computer});
    }
    plan.steps.push_back(std::move(step));
  }
  return made;
}

/// Compares times of one run. Storing the boxes of all pieces of a turn took 70 times as long.
TEST(ExplodedView, ScrewsThatTurnTakeLittleLongerThanBodiesThatLeaveStraight) {
  const auto leastOfThree = [](bool turns) {
    const auto [product, plan] = blocksThatLeave(250, turns);
    BodySet leaves(product.bodies.size(), true);
    leaves[0] = false;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 3; ++round) {
      const auto begun = std::chrono::steady_clock::now();
      const ExplodedView view(product, plan);
      least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
      expectApart(product, view.at(1.0), leaves);
    }
    return least;
  };
  EXPECT_LT(leastOfThree(true), 20.0 * leastOfThree(false));
}

TEST(ExplodedView, WithoutStepsNothingMoves) {
  const AssembledProduct product = test::chain();
  for (const Pose& moved : ExplodedView(product, {}).at(1.0)) EXPECT_EQ(moved, Pose::identity());
}

}  // namespace
}  // namespace glissade
