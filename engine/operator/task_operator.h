#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/geometry/se3_metric.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// Skill of a person at the level of a task: the poses of the object, not the motion of the hand. Lengths are shares of
/// the object's size, which is twice its radius, so that one level is the same for every problem.
struct TaskLevel {
  std::string_view id;
  double positionError;   ///< standard deviation of a way-point, share of the size
  double angleError;      ///< standard deviation of its orientation, rad
  double linearSpeed;     ///< largest speed, sizes per second
  double angularSpeed;    ///< largest angular speed, rad/s
  double reaction;        ///< seconds before each movement
  double fatigue;         ///< loss of speed per minute, as a share
  bool misleads = false;  ///< the way points are at random places
};

/// The levels task-expert, task-novice, misleading. README.md has the sources of the figures.
const std::array<TaskLevel, 3>& taskLevels();

/// The way points of a task: equally spaced configurations of a path that an independent run has found, and its end.
/// Their distance is half a radius of the object in the metric, for every problem.
std::vector<Pose> taskRoute(const std::vector<Pose>& path, const Se3Metric& metric);

/// A simulated person who shows a way. The object is moved from one way point to the next, each with the errors of the
/// level, drawn anew in every pass, and then back again. Movements have minimum jerk (Flash and Hogan 1985). They do
/// not depend on the roadmap, and obstacles do not block them. Deterministic for a seed and the same calls.
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
  std::optional<Pose> shown_;  ///< last returned pose; differs from q_device after another source has moved the object
  double time_ = 0.0;          ///< seconds since the run began
  double waiting_ = 0.0;       ///< seconds of reaction left
  double elapsed_ = 0.0;       ///< elapsed seconds of the movement
  double duration_ = 0.0;      ///< duration of the movement in seconds; 0: none
};

}  // namespace glissade
