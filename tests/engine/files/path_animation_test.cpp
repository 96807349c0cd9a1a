#include "engine/files/path_animation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

constexpr double kSeconds = 10.0;

double lengthOf(const std::vector<Pose>& path, const Se3Metric& metric) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += metric.distance(path[i - 1], path[i]);
  return sum;
}

/// Pose of the object at a metric length of the path.
Pose poseAfter(double length, const std::vector<Pose>& path, const Se3Metric& metric) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double edge = metric.distance(path[i - 1], path[i]);
    if (length <= edge && edge > 0.0) return interpolate(path[i - 1], path[i], length / edge);
    length -= edge;
  }
  return path.back();
}

/// The pose that a player of glTF shows (spherical), or a player that interpolates the components of quaternions.
Pose played(const std::vector<KeyFrame>& frames, double time, bool spherical) {
  std::size_t next = 1;
  while (next + 1 < frames.size() && static_cast<double>(frames[next].time) < time) ++next;
  const KeyFrame& a = frames[next - 1];
  const KeyFrame& b = frames[next];
  const double t = (time - a.time) / (static_cast<double>(b.time) - a.time);
  Pose q = interpolate(a.q, b.q, t);
  if (!spherical) {
    q.orientation.coeffs() = (1.0 - t) * a.q.orientation.coeffs() + t * b.q.orientation.coeffs();
    q.orientation.normalize();
  }
  return q;
}

std::vector<Pose> randomPath(RandomStream& stream) {
  std::vector<Pose> path;
  for (int i = 0; i < 12; ++i) path.push_back(randomPose(stream, 2.0));
  return path;
}

/// Checks that each frame is strictly later than the one before, and in its hemisphere.
void expectInOrder(const std::vector<KeyFrame>& frames) {
  ASSERT_FALSE(frames.empty());
  EXPECT_EQ(frames.front().time, 0.0F);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_GT(frames[i].time, frames[i - 1].time) << i;
    EXPECT_GE(frames[i].q.orientation.dot(frames[i - 1].q.orientation), 0.0) << i;
  }
}

TEST(PathAnimation, PlaysThePathAtConstantSpeedInTheMetric) {
  RandomStream stream(3, "paths");
  const Se3Metric metric(0.7);
  for (int run = 0; run < 20; ++run) {
    const std::vector<Pose> path = randomPath(stream);
    const std::vector<KeyFrame> frames = keyFramesOf(path, metric, kSeconds);
    expectInOrder(frames);
    EXPECT_NEAR(frames.back().time, kSeconds, 1e-5);
    const double length = lengthOf(path, metric);
    for (int i = 0; i < 200; ++i) {
      const double time = stream.uniform(0.0, kSeconds);
      const Pose expected = poseAfter(length * time / kSeconds, path, metric);
      EXPECT_LT(metric.distance(played(frames, time, true), expected), 2e-7 * length);  // times have single precision
      EXPECT_LT(metric.distance(played(frames, time, false), expected), 4e-5);
    }
  }
}

TEST(PathAnimation, HoldsEveryConfiguration) {
  RandomStream stream(4, "paths");
  const std::vector<Pose> path = randomPath(stream);
  const std::vector<KeyFrame> frames = keyFramesOf(path, Se3Metric(1.0), kSeconds);
  for (const Pose& q : path) {
    EXPECT_TRUE(std::any_of(frames.begin(), frames.end(), [&](const KeyFrame& frame) {
      return frame.q.position == q.position && angleBetween(frame.q.orientation, q.orientation) < 1e-12;
    }));
  }
}

TEST(PathAnimation, ATurnByHalfACircleHasTheSenseOfThePath) {
  const Pose start;
  const Pose half{{1, 0, 0}, Quaternion(Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitZ()))};
  const std::vector<KeyFrame> frames = keyFramesOf({start, half}, Se3Metric(1.0), kSeconds);
  expectInOrder(frames);
  EXPECT_LT(angleBetween(played(frames, 5.0, true).orientation, interpolate(start, half, 0.5).orientation), 1e-6);
}

TEST(PathAnimation, EqualConfigurationsStillTakeTime) {
  const Pose a = Pose::translation({1, 2, 3});
  const Pose b = Pose::translation({1, 2, 4});
  const Pose nearly = Pose::translation({1, 2, 4.0 + 1e-9});
  for (const std::vector<Pose>& path : {std::vector<Pose>{a, a, b, b, nearly, nearly}, {a, a, a}, {a}}) {
    const std::vector<KeyFrame> frames = keyFramesOf(path, Se3Metric(1.0), kSeconds);
    EXPECT_EQ(frames.size(), path.size());
    expectInOrder(frames);
  }
}

TEST(PathAnimation, QuaternionsThatFilesHaveRoundedAreUnitOnes) {
  Pose q;
  q.orientation.coeffs() *= 1.0005;
  for (const KeyFrame& frame : keyFramesOf({q, q}, Se3Metric(1.0), kSeconds)) {
    EXPECT_NEAR(frame.q.orientation.norm(), 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace glissade
