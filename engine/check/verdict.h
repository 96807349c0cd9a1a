#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade::check {

enum class Status {
  Certified,  ///< proved: the clearance keeps the demand on the whole motion
  Violated,   ///< a configuration with less clearance was found
  Undecided   ///< stopped, or out of steps, before either was shown
};

/// The clearance that an edge of a path has to keep.
struct Demand {
  double clearance = 0.0;  ///< metres, > 0
  bool sliding = false;    ///< the edge touches a contact configuration, so that half of the contact gap is demanded
};

/// A nearest pair of points of the moving body and another body.
struct Nearest {
  double distance = 0.0;  ///< metres; 0 if the bodies touch, penetrate, or one is inside the other
  int body = -1;          ///< number of the other body; -1: there is none
  Vector3 onBody = Vector3::Zero();
  Vector3 onMoving = Vector3::Zero();
};

/// One edge of a path: its smallest clearance lies in [provedClearance, minClearance].
struct EdgeVerdict {
  Status status = Status::Undecided;
  Demand demand;
  double provedClearance = 0.0;  ///< metres, lower bound
  double minClearance = 0.0;     ///< smallest clearance that was met, metres
  double at = 0.0;               ///< place of the smallest clearance on the edge, in [0, 1]
  Nearest nearest;
};

/// The proof of a motion or a path; it does not rely on samples.
struct MotionVerdict {
  Status status = Status::Undecided;
  double demanded = 0.0;           ///< metres; for a path the largest demand of an edge
  double minClearance = 0.0;       ///< smallest clearance that was met, metres
  double certified = 0.0;          ///< for a single motion: it is proved on [0, certified]
  double provedClearance = 0.0;    ///< metres, lower bound over the whole motion
  std::size_t edge = 0;            ///< edge with the smallest distance, or the edge that is not certified
  double at = 0.0;                 ///< place on that edge, in [0, 1]
  Nearest nearest;                 ///< nearest pair at that place
  bool againstThread = false;      ///< violated because the pair is a thread and the edge is no turn in it
  std::uint64_t distances = 0;     ///< number of measured distances
  std::vector<EdgeVerdict> edges;  ///< edges of a path, up to the first that is not certified
};

}  // namespace glissade::check
