#include "engine/planning/path_spacing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace glissade {
namespace {

using By = PathSpacing::By;

const Se3Metric kSpacingMetric(0.5);

std::vector<Pose> cornerWay() {
  return {Pose::translation({0, 0, 0}), Pose::translation({1, 0, 0}), Pose::translation({1, 3, 0})};
}

TEST(PathSpacing, ANumberOfPosesAreEquallyFarFromEachOther) {
  const std::vector<Pose> poses = posesAlong(cornerWay(), kSpacingMetric, {By::Number, 3, 0.0});
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_LT((poses[0].position - Vector3(1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((poses[1].position - Vector3(1, 1, 0)).norm(), 1e-9);
  EXPECT_LT((poses[2].position - Vector3(1, 2, 0)).norm(), 1e-9);
}

TEST(PathSpacing, ADistanceIsKeptAndNeitherEndHasAPose) {
  EXPECT_EQ(posesAlong(cornerWay(), kSpacingMetric, {By::Distance, 0, 0.5}).size(), 7U);
  EXPECT_EQ(posesAlong(cornerWay(), kSpacingMetric, {By::Distance, 0, 0.7}).size(), 5U);
  EXPECT_TRUE(posesAlong(cornerWay(), kSpacingMetric, {By::Distance, 0, 5.0}).empty());
  EXPECT_TRUE(posesAlong(cornerWay(), kSpacingMetric, {By::None, 5, 0.5}).empty());
}

TEST(PathSpacing, ATurnOnTheSpotHasPosesToo) {
  const Pose turned{Vector3::Zero(), Quaternion(Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3::UnitZ()))};
  EXPECT_EQ(posesAlong({Pose::identity(), turned}, kSpacingMetric, {By::Number, 4, 0.0}).size(), 4U);
}

TEST(PathSpacing, ThereAreNeverTooMany) {
  const std::size_t most = kMostPathPoses;
  EXPECT_EQ(posesAlong(cornerWay(), kSpacingMetric, {By::Distance, 0, 1e-6}).size(), most);
  EXPECT_EQ(posesAlong(cornerWay(), kSpacingMetric, {By::Number, 100'000, 0.0}).size(), most);
  EXPECT_TRUE(posesAlong({}, kSpacingMetric, {}).empty());
}

}  // namespace
}  // namespace glissade
