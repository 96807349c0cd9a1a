#pragma once

#include <vector>

#include "engine/base/message.h"
#include "engine/check/motion_bodies.h"
#include "engine/check/motion_check.h"
#include "engine/check/pair_fit.h"

namespace glissade::check {

/// Another body that a motion is judged against.
struct MotionPair {
  std::size_t body = 0;  ///< number of the other body, for the caller
  const Body* other = nullptr;
  PairFit fit{};
};

/// Judges the motion of one body against others, each pair with the shapes of its fit. `X_PB`: pose of the body in the
/// frame of the path. The verdict names other bodies by MotionPair::body.
struct MotionQuestion {
  const Body& moving;
  Pose X_PB;
  std::vector<Pose> path;
  std::vector<Demand> demands;
  std::vector<MotionPair> pairs;
};

struct JudgedMotion {
  MotionVerdict verdict;
  Message why{};  ///< reason of an undecided verdict; else empty
};

JudgedMotion judgeMotion(const MotionQuestion& question, MotionBodies& prepared, const WorkWatch& watch);

/// The configurations of the points, with unit rotations.
std::vector<Pose> configurationsOf(const std::vector<Point>& points);

/// The demand of each edge: the required clearance, or half of the contact gap if that is less and the edge begins or
/// ends at a contact configuration.
std::vector<Demand> demandsOf(const std::vector<Point>& points, double required, double contactGap);

}  // namespace glissade::check
