#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade::check {

enum class Status {
  Certified,  ///< proved: the clearance stays at or above what is demanded on the whole motion
  Violated,   ///< a configuration with less clearance was found
  Undecided   ///< stopped, or out of steps, before either was shown
};

/// What an edge of a path has to keep.
struct Demand {
  double clearance = 0.0;  ///< metres, > 0
  bool sliding = false;    ///< it touches a contact configuration, and is held to half of the contact gap instead
};

/// A nearest pair of points of the moving body and of another one.
struct Nearest {
  double distance = 0.0;  ///< metres; 0 where the two touch, penetrate, or one is inside the other
  int body = -1;          ///< number of the other one; -1: there is none
  Vector3 onBody = Vector3::Zero();
  Vector3 onMoving = Vector3::Zero();
};

/// One edge of a path: its smallest clearance lies in [provedClearance, minClearance].
struct EdgeVerdict {
  Status status = Status::Undecided;
  Demand demand;
  double provedClearance = 0.0;  ///< metres, lower bound
  double minClearance = 0.0;     ///< metres, the smallest that was met
  double at = 0.0;               ///< where on the edge, in [0, 1]
  Nearest nearest;
};

/// What is proved of a motion or of a path, never by samples.
struct MotionVerdict {
  Status status = Status::Undecided;
  double demanded = 0.0;           ///< metres; of a path the largest demand of an edge
  double minClearance = 0.0;       ///< metres, the smallest that was met
  double certified = 0.0;          ///< of one motion: it is proved on [0, certified]
  double provedClearance = 0.0;    ///< metres, lower bound over the whole motion
  std::size_t edge = 0;            ///< of the smallest distance, or of what is not certified
  double at = 0.0;                 ///< where on that edge, in [0, 1]
  Nearest nearest;                 ///< the pair there
  bool againstThread = false;      ///< violated: the pair is a thread, and the edge is no turn in it
  std::uint64_t distances = 0;     ///< that were measured
  std::vector<EdgeVerdict> edges;  ///< of a path, up to the first that is not certified
};

}  // namespace glissade::check
