#pragma once

namespace glissade::test {

/// A problem file of OMPL.app: the robot turns by a quarter about z, and the volume has to grow to hold the goal.
inline constexpr const char* kSampleCfg = R"([problem]
name = Test
robot = robot.stl
world = world.stl
# a comment
start.x = 1
start.y = 2
start.z = 3
start.theta = 1.5707963267948966
start.axis.x = 0
start.axis.y = 0
start.axis.z = 2
goal.x = 20
goal.y = 0
goal.z = 0
goal.theta = 0
goal.axis.x = 0
goal.axis.y = 0
goal.axis.z = 0
volume.min.x = -5
volume.min.y = -5
volume.min.z = -5
volume.max.x = 5
volume.max.y = 5
volume.max.z = 5
sampler = obstacle_based

[planner]
rrt =
)";

}  // namespace glissade::test
