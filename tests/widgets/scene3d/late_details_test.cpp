#include "widgets/scene3d/late_details.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "widgets/scene3d/body_shape.h"

namespace glissade {
namespace {

/// A square of 2 n n triangles.
BodyShape plate(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) mesh.vertices.emplace_back(0.01 * i, 0.01 * j, 0.0);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j;
      mesh.triangles.push_back({a, a + n + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  return makeBodyShape(mesh);
}

TEST(LateDetails, AreMadeOnAWorkerWhenTheyAreAskedFor) {
  const BodyShape shape = plate(60);
  const std::vector<ShapeDetail> expected = coarserDetails(shape);
  const auto worker = std::make_shared<DetailWorker>();
  const auto details = std::make_shared<LateDetails>(shape, worker);
  const std::vector<ShapeDetail>* made = details->get();
  while (made == nullptr) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    made = details->get();
  }
  ASSERT_EQ(made->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ((*made)[i].corners->size(), expected[i].corners->size());
    EXPECT_EQ((*made)[i].error, expected[i].error);
  }
}

TEST(LateDetails, AWorkerThatEndsLeavesOutTheRest) {
  const BodyShape shape = plate(60);
  std::vector<std::shared_ptr<LateDetails>> all;
  {
    const auto worker = std::make_shared<DetailWorker>();
    for (int i = 0; i < 500; ++i) all.push_back(std::make_shared<LateDetails>(shape, worker));
    for (const auto& details : all) details->get();
  }
  EXPECT_EQ(all.back()->get(), nullptr);
}

}  // namespace
}  // namespace glissade
