#include "engine/planning/nearest_neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

TEST(NearestNeighbours, AgreesWithThePlainMinimumAlsoForNearlyEqualOrientations) {
  const Se3Metric metric(1.536);
  RandomStream stream(11, "neighbours");
  NearestNeighbours neighbours(metric);
  std::vector<Pose> poses;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    Pose q = randomPose(stream, 2.0);
    if (i % 3 == 0 && i > 0) {  // nearly equal to an earlier one, half of them with the other sign
      q = poses[i / 2];
      q.position += 1e-6 * Vector3(stream.normal(), stream.normal(), stream.normal());
      if (i % 2 == 0) q.orientation.coeffs() *= -1.0;
    }
    poses.push_back(q);
    neighbours.add(i, q);
  }
  for (int trial = 0; trial < 500; ++trial) {
    const Pose q = trial % 2 == 0 ? randomPose(stream, 2.0) : poses[static_cast<std::size_t>(trial)];
    double best = std::numeric_limits<double>::infinity();
    for (const Pose& pose : poses) best = std::min(best, metric.distance(pose, q));
    const auto found = neighbours.nearest(q);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, best);
    EXPECT_EQ(metric.distance(poses[found->index], q), best);
  }
}

/// The tree of boxes finds what a plain scan finds.
class ManyNeighbours : public testing::Test {
 protected:
  void add(const Pose& q) {
    neighbours.add(static_cast<std::uint32_t>(poses.size()), q);
    poses.push_back(q);
  }
  void expectAsPlain(const Pose& q) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double distance = metric.distance(poses[i], q);
      if (distance * distance >= least) continue;
      least = distance * distance;
      best = i;
    }
    const auto found = neighbours.nearest(q);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->index, best);
    EXPECT_EQ(found->distance, metric.distance(poses[best], q));
  }

  Se3Metric metric{0.7};
  NearestNeighbours neighbours{metric};
  std::vector<Pose> poses;
  RandomStream stream{23, "many"};
};

TEST_F(ManyNeighbours, AgreeWithAPlainScanAlsoFarOffAndAmongEquals) {
  while (poses.size() < 10000) {
    const std::size_t n = poses.size();
    Pose q = randomPose(stream, 1.0);
    if (n % 5 == 1) q = poses[n / 2];    // equal to an earlier one, which must be the answer
    if (n % 5 == 2) q.position *= 0.01;  // dense about the origin
    if (n % 5 == 3) q.orientation = poses[0].orientation;
    if (n > 9000 && n % 5 == 4) q.position *= 10.0;
    add(q);
  }
  for (int trial = 0; trial < 300; ++trial) {
    Pose q = randomPose(stream, trial % 3 == 0 ? 12.0 : 1.0);
    if (trial % 3 == 1) q = poses[static_cast<std::size_t>(stream.uniform(0, 10000))];
    if (trial % 7 == 0) q.position *= 0.01;
    expectAsPlain(q);
  }
}

TEST_F(ManyNeighbours, AgreeWithAPlainScanOnALatticeOfEquals) {
  for (int i = 0; i < 3 * 18 * 18 * 18; ++i) {
    add(Pose::translation(Vector3(i % 18, i / 18 % 18, i / 324 % 18)));  // three equal points each
  }
  for (int trial = 0; trial < 300; ++trial) {
    Vector3 p(std::floor(stream.uniform(-3, 21)), std::floor(stream.uniform(0, 18)), std::floor(stream.uniform(0, 18)));
    if (trial % 2 == 0) p += Vector3::Constant(0.5);  // equally far from eight points
    expectAsPlain(Pose::translation(p));
  }
}

TEST_F(ManyNeighbours, AgreeWithAPlainScanOnAPlaneAndInAPoint) {
  for (int i = 0; i < 3000; ++i) {
    Pose q = randomPose(stream, 1.0);
    q.position.z() = 0.25;
    add(q);
  }
  for (int trial = 0; trial < 100; ++trial) expectAsPlain(randomPose(stream, 1.0));
  neighbours = NearestNeighbours(metric);
  poses.clear();
  for (int i = 0; i < 3000; ++i) add(Pose{Vector3::Ones(), randomPose(stream, 1.0).orientation});
  for (int trial = 0; trial < 100; ++trial) expectAsPlain(randomPose(stream, 1.0));
}

TEST_F(ManyNeighbours, AgreeWithAPlainScanTenKilometresFromTheOrigin) {
  const Vector3 offset = Vector3::Constant(1e4);
  const auto near = [&](double reach) {
    Pose q = randomPose(stream, reach);
    q.position += offset;
    return q;
  };
  add(Pose::identity());  // single precision rounds the other points to a millimetre
  for (int i = 0; i < 3000; ++i) add(near(i % 2 == 0 ? 1.0 : 1e-3));
  for (int trial = 0; trial < 300; ++trial) expectAsPlain(near(trial % 2 == 0 ? 1.0 : 1e-3));
}

TEST_F(ManyNeighbours, ThousandsAtOnePlaceAreNoTrouble) {
  for (int i = 0; i < 5000; ++i) add(Pose::translation({1, 2, 3}));
  add(Pose::translation({1, 2, 3.5}));
  expectAsPlain(Pose::translation({1, 2, 3.1}));
  expectAsPlain(Pose::translation({1, 2, 3.4}));
}

TEST(NearestNeighbours, FirstAmongEqualsAndNothingWhenEmpty) {
  NearestNeighbours neighbours(Se3Metric(1.0));
  EXPECT_FALSE(neighbours.nearest(Pose::identity()));
  neighbours.add(7, Pose::identity());
  neighbours.add(3, Pose::identity());
  EXPECT_EQ(neighbours.nearest(Pose::translation({1, 0, 0}))->index, 7U);
}

}  // namespace
}  // namespace glissade
