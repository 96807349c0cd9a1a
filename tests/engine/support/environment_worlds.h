#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/places/environment_model.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade::test {

/// Boxes and cylinders of all sizes, every other one mobile, somewhere in or about a unit cube.
inline std::vector<RigidBody> randomBodies(RandomStream& stream, int count) {
  std::vector<RigidBody> bodies;
  for (int i = 0; i < count; ++i) {
    RigidBody body;
    body.name = "body " + std::to_string(i);
    body.id = BodyId(body.name);
    body.mobility = i % 2 == 0 ? Mobility::Static : Mobility::Mobile;
    TriangleMesh mesh;
    if (i % 3 == 0) {
      mesh = makeCylinder(stream.uniform(0.03, 0.2), stream.uniform(0.05, 0.5), 12);
    } else {
      mesh = makeBox({stream.uniform(0.05, 0.5), stream.uniform(0.05, 0.5), stream.uniform(0.05, 0.5)});
    }
    body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    body.X_WB = randomPose(stream, 0.5);
    body.X_WB.position += Vector3::Constant(0.5);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

inline TriangleMesh boxBetween(const Vector3& least, const Vector3& most) {
  return transformed(makeBox(most - least), Pose::translation((least + most) / 2.0));
}

inline Box3 twoRooms() { return Box3(Vector3::Zero(), Vector3(2.0, 1.0, 1.0)); }

/// A wall across `twoRooms()` at x = 1 with a square hole of 0.25 m.
inline std::vector<RigidBody> wallWithAHole() {
  const auto between = [](const char* name, const Vector3& least, const Vector3& most) {
    return boxBody(name, most - least, Pose::translation((least + most) / 2.0));
  };
  return {between("left", {0.9375, 0, 0}, {1.0625, 0.375, 1}), between("right", {0.9375, 0.625, 0}, {1.0625, 1, 1}),
          between("below", {0.9375, 0.375, 0}, {1.0625, 0.625, 0.375}),
          between("above", {0.9375, 0.375, 0.625}, {1.0625, 0.625, 1})};
}

// Points of that world: in the left room, in the hole, in the wall, outside.
inline const Vector3 kLeft(0.3, 0.5, 0.5);
inline const Vector3 kHole(1.0, 0.5, 0.5);
inline const Vector3 kInTheWall(0.95, 0.1, 0.1);
inline const Vector3 kFarAway(5.0, 5.0, 5.0);

/// An environment of box-shaped bodies in small cells; fails the test where it cannot be built.
inline EnvironmentModelPtr environmentOf(const std::vector<RigidBody>& bodies, const Box3& workspace,
                                         const EnvironmentOptions& options) {
  auto built = buildEnvironment(bodies, workspace, options);
  return built ? *built : nullptr;
}

}  // namespace glissade::test
