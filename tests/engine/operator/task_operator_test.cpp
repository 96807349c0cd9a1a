#include "engine/operator/task_operator.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

const Se3Metric kTaskMetric(0.5);  // size of 1 m

const TaskLevel& level(std::string_view id) {
  for (const TaskLevel& level : taskLevels()) {
    if (level.id == id) return level;
  }
  throw std::runtime_error("no such level");
}

/// The places where the simulated person rests: the way points with their errors.
std::vector<Pose> stops(TaskOperator& person, double seconds) {
  std::vector<Pose> stops;
  Pose q;
  for (double t = 0.0; t < seconds; t += 0.01) {
    const Pose next = person.advance(0.01, viewOf(q), kRoom);
    if (next == q && (stops.empty() || stops.back() != q)) stops.push_back(q);
    q = next;
  }
  return stops;
}

TEST(TaskOperator, WayPointsLieOnThePathAtEqualDistances) {
  const std::vector<Pose> path{Pose::identity(), Pose::translation({0.6, 0, 0}), Pose::translation({0.6, 1, 0})};
  const std::vector<Pose> route = taskRoute(path, kTaskMetric);
  ASSERT_EQ(route.size(), 7U);
  EXPECT_TRUE(route[1].position.isApprox(Vector3(0.5, 0, 0), 1e-12));
  EXPECT_TRUE(route[2].position.isApprox(Vector3(0.6, 0.15, 0), 1e-12));
  EXPECT_EQ(route.back(), path.back());
}

TEST(TaskOperator, ErrorsAreThoseOfTheLevel) {
  for (const char* id : {"task-expert", "task-novice"}) {
    const std::vector<Pose> route{Pose::translation({1, 0, 0}), Pose::translation({2, 0, 0})};
    TaskOperator person(level(id), route, kTaskMetric, 1);
    double positions = 0.0;
    double angles = 0.0;
    int count = 0;
    for (const Pose& stop : stops(person, 4000.0)) {
      const double off =
          std::min((stop.position - route[0].position).norm(), (stop.position - route[1].position).norm());
      if (off > 0.5) continue;  // the start
      positions += off * off;
      angles += std::pow(angleBetween(stop.orientation, Quaternion::Identity()), 2);
      ++count;
    }
    ASSERT_GT(count, 100);
    EXPECT_NEAR(std::sqrt(positions / count), level(id).positionError, 0.15 * level(id).positionError) << id;
    EXPECT_NEAR(std::sqrt(angles / count), level(id).angleError, 0.15 * level(id).angleError) << id;
  }
}

TEST(TaskOperator, KeepsToHisSpeedAndTires) {
  const TaskLevel& novice = level("task-novice");
  const auto firstArrival = [&](double rested) {
    TaskLevel tired = novice;
    tired.fatigue = rested;
    TaskOperator person(tired, {Pose::translation({1, 0, 0}), Pose::translation({2, 0, 0})}, kTaskMetric, 1);
    Pose q;
    int passes = 0;
    double t = 0.0;
    for (; t < 3000.0 && passes < 40; t += 0.02) {
      const Pose next = person.advance(0.02, viewOf(q), kRoom);
      EXPECT_LE((next.position - q.position).norm(), 1.001 * 0.02 * novice.linearSpeed * 1.0);
      if ((next.position.x() > 1.5) != (q.position.x() > 1.5)) ++passes;
      q = next;
    }
    return t;
  };
  EXPECT_GT(firstArrival(0.5), 1.2 * firstArrival(0.0));
}

TEST(TaskOperator, SeedsDecideAndSomebodyWhoMisleadsDoesNotFollowTheRoute) {
  const auto walk = [](std::string_view id, std::uint64_t seed) {
    TaskOperator person(level(id), {Pose::translation({1, 0, 0})}, kTaskMetric, seed);
    Pose q;
    for (int i = 0; i < 500; ++i) q = person.advance(0.025, viewOf(q), kRoom);
    return q;
  };
  EXPECT_EQ(walk("misleading", 1), walk("misleading", 1));
  EXPECT_NE(walk("misleading", 1), walk("misleading", 2));
  EXPECT_GT((walk("misleading", 1).position - Vector3(1, 0, 0)).norm(), 0.5);
}

}  // namespace
}  // namespace glissade
