#pragma once

#include "engine/base/random_stream.h"
#include "samples/made-problems/made_problem.h"
#include "samples/made-problems/swept_section.h"

namespace glissade::made {

/// The line of a tube: pieces of 1.2 m with a curvature each in a random direction, and a twist.
struct Line {
  int pieces = 4;
  double radius = 1.1;  ///< radius of the bends
  double twist = 0.0;   ///< radians per metre
};

inline Frames framesAlong(const Line& line, RandomStream& stream) {
  constexpr double kPiece = 1.2;
  constexpr int kSteps = 12;
  constexpr double kStep = kPiece / kSteps;
  Frames frames{Pose::identity()};
  for (int piece = 0; piece < line.pieces; ++piece) {
    const double direction = stream.uniform(0.0, 2.0 * std::acos(-1.0));
    for (int i = 0; i < kSteps; ++i) {
      const Pose& last = frames.back();
      // The twist so far is subtracted, so that a bend stays in its plane.
      const double twisted = line.twist * kStep * i;
      const Vector3 bend(std::cos(direction - twisted), std::sin(direction - twisted), 0.0);
      const Vector3 turn = kStep * (bend / line.radius + Vector3(0.0, 0.0, line.twist));
      const Quaternion step(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
      const Vector3 along = last.orientation * Vector3(0.0, 0.0, kStep);
      frames.push_back({last.position + along, (last.orientation * step).normalized()});
    }
  }
  return frames;
}

/// The object moves from near one end of a tube, which a plate of half a metre closes, to near the other end.
inline MadeProblem inTube(const std::string& name, const std::string& description, const Frames& frames,
                          const TriangleMesh& tube, const TriangleMesh& object) {
  constexpr std::size_t kFromEnd = 4;
  constexpr double kPlate = 0.05;
  const Box3 around = boundingBox(tube);
  const Vector3 margin = Vector3::Constant(0.5);
  TriangleMesh obstacles = tube;
  append(obstacles, transformed(boxBetween({-0.5, -0.5, -kPlate}, {0.5, 0.5, 0.0}), frames.front()));
  return {name,
          description,
          object,
          std::move(obstacles),
          frames[kFromEnd],
          frames[frames.size() - 1 - kFromEnd],
          Box3(around.min() - margin, around.max() + margin)};
}

/// A block in a tube of rectangular section that bends and twists.
inline MadeProblem blockInTwistedTube(std::uint64_t seed) {
  constexpr double kWide = 0.5;
  constexpr double kHigh = 0.32;
  constexpr double kWall = 0.05;
  RandomStream stream(seed, "tube");
  const Frames frames = framesAlong({4, 1.1, 0.7}, stream);
  const TriangleMesh tube =
      tubeAlong(frames, rectangularSection(kWide, kHigh), rectangularSection(kWide + 2.0 * kWall, kHigh + 2.0 * kWall));
  return inTube("tube-block-" + std::to_string(seed), "A block through a tube that bends and twists.", frames, tube,
                makeBox({0.38, 0.2, 0.3}));
}

/// A bent rod in a round tube: the rod turns about the tube's line from bend to bend.
inline MadeProblem rodInTube(std::uint64_t seed) {
  constexpr double kRadius = 0.2;
  constexpr double kWall = 0.05;
  constexpr int kCorners = 16;
  RandomStream stream(seed, "tube");
  const Frames frames = framesAlong({4, 1.0, 0.0}, stream);
  const TriangleMesh tube =
      tubeAlong(frames, regularSection(kRadius, kCorners), regularSection(kRadius + kWall, kCorners));
  // An arc of 0.6 m with the radius of the bends and its middle at the origin.
  constexpr int kSteps = 10;
  constexpr double kHalfArc = 0.3;
  Frames arc;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = kHalfArc * (2.0 * i / kSteps - 1.0);
    arc.push_back(turnedAt({1.0 - std::cos(angle), 0.0, std::sin(angle)}, angle, {0, 1, 0}));
  }
  return inTube("tube-rod-" + std::to_string(seed), "A bent rod through a round tube that bends.", frames, tube,
                solidAlong(arc, regularSection(0.09, 8)));
}

}  // namespace glissade::made
