#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/geometry/se3_metric.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// How well somebody shows a way, at the level of a task: where he puts the object, not how his hand moves. Lengths are
/// shares of the object's size, which is twice its radius, so that one level is the same for every problem.
struct TaskLevel {
  std::string_view id;
  double positionError;   ///< standard deviation of a way-point, share of the size
  double angleError;      ///< the same of its orientation, rad
  double linearSpeed;     ///< at most, sizes a second
  double angularSpeed;    ///< at most, rad/s
  double reaction;        ///< s, before each movement
  double fatigue;         ///< by how much slower he gets in a minute, share
  bool misleads = false;  ///< his way-points lie anywhere
};

/// task-expert, task-novice, misleading. README.md has the sources of the figures.
const std::array<TaskLevel, 3>& taskLevels();

/// The way-points of a task: equally spaced configurations of a path that an independent run has found, and its end.
/// The same rule for every problem: half a radius of the object from one to the next, in the metric.
std::vector<Pose> taskRoute(const std::vector<Pose>& path, const Se3Metric& metric);

/// A person who shows a way: he moves the object to one way-point after the other, each off by the errors of his level,
/// drawn anew in every pass, and then back again. Movements have minimum jerk (Flash and Hogan 1985). He does not look
/// at the roadmap, and is not blocked by obstacles. Deterministic for a seed and the same calls.
class TaskOperator final : public OperatorDevice {
 public:
  TaskOperator(const TaskLevel& level, std::vector<Pose> route, const Se3Metric& metric, std::uint64_t seed);

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override;
  bool isSimulated() const override { return true; }

 private:
  void beginMovement(const Pose& from, const Box3& bounds);
  Pose shownWayPoint(const Box3& bounds);
  double tiredness() const { return 1.0 + level_.fatigue * time_ / 60.0; }

  TaskLevel level_;
  std::vector<Pose> route_;
  double size_;
  RandomStream stream_;
  std::size_t next_ = 0;
  bool forwards_ = true;
  Pose from_;
  Pose to_;
  std::optional<Pose> shown_;  ///< what was returned last; differs from q_device after somebody put the object
  double time_ = 0.0;          ///< s since the run began
  double waiting_ = 0.0;       ///< s of reaction left
  double elapsed_ = 0.0;       ///< s of the movement
  double duration_ = 0.0;      ///< s of the movement; 0: none
};

}  // namespace glissade
