#pragma once

#include <cstdint>

#include "tests/oracle/scene_file.h"

namespace glissade::oracle {

/// What dense samples of a path came to.
struct Verdict {
  std::uint64_t poses = 0;
  std::uint64_t penetrating = 0;  ///< poses in which the object meets a body, or lies in one, or around one
  double depth = 0.0;             ///< lower bound of the deepest penetration met, metres; 0: surfaces only cross
};

/// Exact predicates (CGAL) decide about every sampled pose: whether triangles of the two surfaces meet, and
/// whether one solid contains a point of the other, by the signed crossings of a segment to a far point.
class ExactJudge {
 public:
  explicit ExactJudge(Scene scene);
  ~ExactJudge();

  /// Adds the poses of a path. No point of the object goes farther than `step` of the object's size between
  /// two samples, unless that asks for more than `mostSamples` for one edge. Of a turn by half a circle, whose
  /// sense rounding decides, the better sense counts.
  void judge(const std::vector<Placement>& path, double step, int mostSamples, Verdict& verdict) const;
  bool penetrates(const Placement& pose) const;
  /// The largest distance from a body's surface of a vertex of the object that lies in it, or the reverse.
  double depthAt(const Placement& pose) const;

 private:
  struct Solid;

  Verdict judgeEdge(const Placement& a, const Placement& b, int samples) const;
  Solid objectAt(const Placement& pose) const;

  Scene scene_;
  std::vector<Solid> bodies_;
  std::vector<Point> parts_;  ///< a corner of each connected part of the object
  double radius_ = 0.0;       ///< of the object about its reference point
};

}  // namespace glissade::oracle
