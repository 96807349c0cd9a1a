#pragma once

#include <cstdint>

#include "tests/oracle/scene_file.h"

namespace glissade::oracle {

/// Result of dense samples of a path.
struct Verdict {
  std::uint64_t poses = 0;
  std::uint64_t penetrating = 0;  ///< number of poses in which the object meets a body, lies in one, or lies around one
  double depth = 0.0;             ///< lower bound of the deepest penetration found, metres; 0: only surfaces cross
};

/// Decides about every sampled pose with exact predicates (CGAL): whether triangles of the two surfaces meet, and
/// whether one solid contains a point of the other, by the signed crossings of a segment to a far point.
class ExactJudge {
 public:
  explicit ExactJudge(Scene scene);
  ~ExactJudge();

  /// Adds the poses of a path. No point of the object moves by more than `step` of the object's size between two
  /// samples, unless that needs more than `mostSamples` for one edge. For a turn by half a circle, whose sense rounding
  /// decides, the better sense counts.
  void judge(const std::vector<Placement>& path, double step, int mostSamples, Verdict& verdict) const;
  bool penetrates(const Placement& pose) const;
  /// The largest distance of an object's vertex inside a body from the body's surface, or the reverse.
  double depthAt(const Placement& pose) const;

 private:
  struct Solid;

  Verdict judgeEdge(const Placement& a, const Placement& b, int samples) const;
  Solid objectAt(const Placement& pose) const;

  Scene scene_;
  std::vector<Solid> bodies_;
  std::vector<Point> parts_;  ///< one corner of each connected part of the object
  double radius_ = 0.0;       ///< radius of the object about its reference point
};

}  // namespace glissade::oracle
