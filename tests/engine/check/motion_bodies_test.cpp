#include "engine/check/motion_bodies.h"

#include <gtest/gtest.h>

#include <thread>

#include "engine/evidence/thinning.h"
#include "engine/geometry/primitives.h"

namespace glissade::check {
namespace {

MeshPtr ball(int subdivisions) { return std::make_shared<const TriangleMesh>(makeSphere(0.01, subdivisions)); }

std::vector<Body> bodiesOf(const std::vector<MeshPtr>& meshes) {
  std::vector<Body> bodies;
  for (const MeshPtr& mesh : meshes)
    bodies.push_back({BodyId(std::to_string(bodies.size())), "", mesh, Pose::identity()});
  return bodies;
}

TEST(MotionBodies, MakesTheSameOnce) {
  const MeshPtr mesh = ball(2);
  MotionBodies bodies(bodiesOf({mesh}));
  const double scale = bodies.scaleFor({mesh.get()}, {});
  const auto here = bodies.obstacle(mesh, Pose::identity(), scale);
  EXPECT_EQ(bodies.obstacle(mesh, Pose::identity(), scale), here);
  EXPECT_NE(bodies.obstacle(mesh, Pose::translation({1e-9, 0, 0}), scale), here);
  EXPECT_NE(bodies.obstacle(mesh, Pose::identity(), 2.0 * scale), here);

  const std::vector<double> some(mesh->triangles.size(), 1e-4);
  std::vector<double> others = some;
  others[3] = 2e-4;
  EXPECT_EQ(bodies.taken(mesh, {}), mesh);
  const MeshPtr thin = bodies.taken(mesh, some);
  EXPECT_EQ(thin->vertices, thinned(*mesh, some).vertices);
  EXPECT_EQ(bodies.taken(mesh, some), thin);
  EXPECT_NE(bodies.taken(mesh, others), thin);
}

/// An obstacle that was dropped is made again, and stays valid where it is in use.
TEST(MotionBodies, ForgetsThoseNotAskedForLong) {
  const MeshPtr mesh = ball(2);
  MotionBodies bodies(bodiesOf({mesh}), 3 * mesh->triangles.size());
  const auto first = bodies.obstacle(mesh, Pose::identity(), 1.0);
  for (int i = 1; i < 4; ++i) bodies.obstacle(mesh, Pose::translation({0.1 * i, 0, 0}), 1.0);
  EXPECT_EQ(first.use_count(), 1);
  const auto last = bodies.obstacle(mesh, Pose::translation({0.1 * 3, 0, 0}), 1.0);
  EXPECT_EQ(last.use_count(), 2);
}

TEST(MotionBodies, ThreadsGetTheSame) {
  const MeshPtr mesh = ball(2);
  MotionBodies bodies(bodiesOf({mesh}));
  const std::vector<double> some(mesh->triangles.size(), 1e-4);
  std::vector<MeshPtr> got(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < got.size(); ++i) threads.emplace_back([&, i] { got[i] = bodies.taken(mesh, some); });
  for (std::thread& each : threads) each.join();
  for (const MeshPtr& each : got) EXPECT_EQ(each, got[0]);
}

}  // namespace
}  // namespace glissade::check
