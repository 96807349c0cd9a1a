#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/geometry/primitives.h"
#include "engine/planning/problem.h"

namespace glissade {

inline RigidBody boxBody(const std::string& name, const Vector3& size, const Pose& X_WB) {
  RigidBody body;
  body.id = BodyId(name);
  body.name = name;
  body.mesh = std::make_shared<const TriangleMesh>(makeBox(size));
  body.X_WB = X_WB;
  return body;
}

/// The L of paper 1 (facts of environment 1).
inline MeshPtr makeL() {
  TriangleMesh mesh = makeBox({0.4, 0.4, 0.4});
  append(mesh, transformed(makeBox({0.4, 0.4, 1.6}), Pose::translation({0.4, 0.0, 0.6})));
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// A cube of 0.4 m that must get through a window of 1 m in a wall: solved in well under a second.
inline Problem windowProblem() {
  std::vector<RigidBody> walls;
  walls.push_back(boxBody("left", {0.2, 2.0, 5.0}, Pose::translation({0.0, -1.5, 0.0})));
  walls.push_back(boxBody("right", {0.2, 2.0, 5.0}, Pose::translation({0.0, 1.5, 0.0})));
  walls.push_back(boxBody("below", {0.2, 1.0, 2.0}, Pose::translation({0.0, 0.0, -1.5})));
  walls.push_back(boxBody("above", {0.2, 1.0, 2.0}, Pose::translation({0.0, 0.0, 1.5})));
  Problem problem;
  problem.world = CollisionWorld::build(walls, std::make_shared<const TriangleMesh>(makeBox({0.4, 0.4, 0.4})));
  problem.start = Pose::translation({-1.5, 0.0, 0.0});
  problem.goal = Pose::translation({1.5, 0.5, 0.5});
  problem.bounds = Box3(Vector3(-2.0, -2.0, -2.0), Vector3(2.0, 2.0, 2.0));
  problem.scene.environment = {0.125, 16.0, 5, "region-growing"};  // coarse, so that it is built at once
  return problem;
}

/// A wall without a window, so that there is no path.
inline Problem closedProblem() {
  Problem problem = windowProblem();
  problem.world = CollisionWorld::build({boxBody("wall", {0.2, 5.0, 5.0}, Pose::identity())},
                                        std::make_shared<const TriangleMesh>(makeBox({0.4, 0.4, 0.4})));
  return problem;
}

}  // namespace glissade
