#pragma once

#include <vector>

#include "engine/check/motion_bodies.h"
#include "engine/check/motion_check.h"
#include "engine/check/pair_fit.h"

namespace glissade::check {

/// One other body, as a motion is judged against it.
struct MotionPair {
  std::size_t body = 0;  ///< number of the other one, for the caller
  const Body* other = nullptr;
  PairFit fit{};
};

/// Judges the motion of one body against others, each pair taken as its fit says. `X_PB`: the body in the frame of the
/// path. The verdict names the others by MotionPair::body.
struct MotionQuestion {
  const Body& moving;
  Pose X_PB;
  std::vector<Pose> path;
  std::vector<Demand> demands;
  std::vector<MotionPair> pairs;
};

struct JudgedMotion {
  MotionVerdict verdict;
  std::string why{};  ///< why it is undecided; else empty
};

JudgedMotion judgeMotion(const MotionQuestion& question, MotionBodies& prepared, const WorkWatch& watch);

/// Of points whose rotations are of unit length.
std::vector<Pose> configurationsOf(const std::vector<Point>& points);

/// What each edge has to keep: the required clearance; half of the contact gap, if that is less, where the edge begins
/// or ends at a contact configuration.
std::vector<Demand> demandsOf(const std::vector<Point>& points, double required, double contactGap);

}  // namespace glissade::check
