#pragma once

#include "engine/base/random_stream.h"
#include "samples/made-problems/made_problem.h"
#include "samples/made-problems/swept_section.h"

namespace glissade::made {

/// A wire that is bent to a helix about z.
struct Spiral {
  double radius = 0.5;
  double pitch = 0.3;
  double turns = 3.0;
  double wire = 0.05;  ///< radius
};

inline TriangleMesh spiralMesh(const Spiral& spiral) {
  constexpr int kPerTurn = 20;
  constexpr int kCorners = 8;
  const double rise = spiral.pitch / (2.0 * std::acos(-1.0));
  Frames frames;
  const int count = static_cast<int>(std::lround(kPerTurn * spiral.turns));
  for (int i = 0; i <= count; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / kPerTurn;
    const Vector3 out(std::cos(angle), std::sin(angle), 0.0);
    const Vector3 along = Vector3(-spiral.radius * out.y(), spiral.radius * out.x(), rise).normalized();
    Eigen::Matrix3d axes;
    axes << out, along.cross(out), along;
    const double height = rise * angle - 0.5 * spiral.pitch * spiral.turns;
    frames.push_back({spiral.radius * out + Vector3(0.0, 0.0, height), Quaternion(axes)});
  }
  return solidAlong(frames, regularSection(spiral.wire, kCorners));
}

inline Quaternion anyOrientation(RandomStream& stream) {
  const double w = stream.normal();
  const double x = stream.normal();
  const double y = stream.normal();
  const double z = stream.normal();
  return Quaternion(w, x, y, z).normalized();
}

/// Bodies in a cube of 3 m, between the start on one side and the goal on the other.
inline MadeProblem acrossTheCube(const std::string& name, const std::string& description, TriangleMesh obstacles,
                                 const TriangleMesh& object) {
  constexpr double kHalf = 1.5;
  constexpr double kBeside = 2.4;
  return {name,
          description,
          object,
          std::move(obstacles),
          Pose::translation({-kBeside, 0, 0}),
          turnedAt({kBeside, 0, 0}, std::acos(-1.0) / 2.0, {1, 0, 0}),
          Box3(Vector3(-3.2, -kHalf, -kHalf), Vector3(3.2, kHalf, kHalf))};
}

inline Vector3 anyInCube(double half, RandomStream& stream) {
  const double x = stream.uniform(-half, half);
  const double y = stream.uniform(-half, half);
  const double z = stream.uniform(-half, half);
  return {x, y, z};
}

/// A spiral through a cloud of bars in all directions.
inline MadeProblem spiralAmongBars(std::uint64_t seed) {
  constexpr int kBars = 40;
  RandomStream stream(seed, "bars");
  TriangleMesh obstacles;
  for (int i = 0; i < kBars; ++i) {
    const Vector3 at = anyInCube(1.4, stream);
    append(obstacles, transformed(makeBox({0.06, 0.06, stream.uniform(0.6, 1.6)}), {at, anyOrientation(stream)}));
  }
  return acrossTheCube("spiral-bars-" + std::to_string(seed), "A spiral through a cloud of 40 bars.",
                       std::move(obstacles), spiralMesh({}));
}

/// A spiral through a cloud of spirals.
inline MadeProblem spiralAmongSpirals(std::uint64_t seed) {
  constexpr int kSpirals = 14;
  RandomStream stream(seed, "spirals");
  TriangleMesh obstacles;
  for (int i = 0; i < kSpirals; ++i) {
    const Vector3 at = anyInCube(1.3, stream);
    const Spiral spiral{stream.uniform(0.2, 0.5), 0.3, stream.uniform(1.0, 3.0), 0.04};
    append(obstacles, transformed(spiralMesh(spiral), {at, anyOrientation(stream)}));
  }
  return acrossTheCube("spiral-spirals-" + std::to_string(seed), "A spiral through a cloud of 14 spirals.",
                       std::move(obstacles), spiralMesh({}));
}

/// A corkscrew in a small plate with a hole: it has to be turned out, as a coil is wider than the hole.
inline MadeProblem spiralInEyelet(int playInMillimetres) {
  constexpr double kHalf = 0.22;
  constexpr double kThick = 0.03;
  constexpr double kWorkspace = 3.0;
  const Spiral spiral{0.5, 0.6, 2.0, 0.05};
  const double hole = spiral.wire + 1e-3 * playInMillimetres;
  // Four boxes around a square hole at the middle of the wire, where it goes along y.
  const auto box = [&](double x0, double z0, double x1, double z1) {
    return boxBetween({spiral.radius + x0, -kThick, z0}, {spiral.radius + x1, kThick, z1});
  };
  TriangleMesh plate = box(-kHalf, -kHalf, -hole, kHalf);
  append(plate, box(hole, -kHalf, kHalf, kHalf));
  append(plate, box(-hole, -kHalf, hole, -hole));
  append(plate, box(-hole, hole, hole, kHalf));
  return {"spiral-eyelet-" + std::to_string(playInMillimetres),
          "A corkscrew that has to be turned out of a hole.",
          spiralMesh(spiral),
          std::move(plate),
          Pose::identity(),
          turnedAt({0, 0, 1.8}, std::acos(-1.0) / 2.0, {1, 0, 0}),
          Box3(Vector3::Constant(-kWorkspace), Vector3::Constant(kWorkspace))};
}

}  // namespace glissade::made
