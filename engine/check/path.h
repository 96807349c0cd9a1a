#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/check/evidence_names.h"
#include "engine/evidence/evidence.h"
#include "engine/evidence/thread.h"
#include "engine/geometry/pose.h"
#include "engine/model/body_id.h"

namespace glissade::check {

/// An allowance as a file states it.
struct StatedAllowance {
  BodyId moving;           ///< id; empty: the object, or the first body of the step
  BodyId body;             ///< id of the other body
  double allowance = 0.0;  ///< metres
  bool yields = false;     ///< the other body is taken thinner, not the moving one
  bool isThread = false;   ///< the file calls the pair a thread
  std::optional<double> pitch{};
  std::optional<StatedThread> thread{};
  bool hollow = false;                 ///< the volume that the other body of the pair fills is taken away
  std::optional<StatedThread> core{};  ///< thread that is taken away: the pair comes apart by turning only
  std::optional<double> overlap{};     ///< measured overlap, metres
  std::optional<Evidence> evidence{};  ///< evidence for the largest allowance of the pair
  std::optional<double> turns{};       ///< turns of the moving body in the thread

  /// True if it belongs to this pair of ids. `first`: the object, or the first body of the step.
  bool isAbout(const BodyId& movingBody, const BodyId& other, const BodyId& first) const {
    return (moving.empty() ? first : moving) == movingBody && body == other;
  }
};

struct Point {
  Pose q;
  bool contact = false;  ///< a contact configuration
};

/// A path file.
struct Path {
  std::vector<Point> points;                                 ///< at least one
  std::optional<std::vector<StatedAllowance>> allowances{};  ///< nothing: the format states none
};

}  // namespace glissade::check
