#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/collision/motion_certificate.h"
#include "engine/geometry/se3_metric.h"
#include "engine/planning/roadmap.h"

namespace glissade {

struct PathPoint {
  Pose q;
  Author author = Author::Computer;
  /// Author of the straight motion that ends here: the author of the later of the two nodes that it joins. It may
  /// differ from `author`, because a path runs up the goal tree from child to parent.
  Author segmentAuthor = Author::Computer;
};

std::vector<Pose> configurationsOf(const std::vector<PathPoint>& points);

/// True if a person has led a part of the way: a hand showed the configurations, or they are contact samples about the
/// held object.
bool isSteered(const std::vector<PathPoint>& points);

/// The run that a path comes from.
struct PathProvenance {
  std::string planner;  ///< id of the planner; empty: unknown
  std::uint64_t seed = 0;
  bool steered = false;  ///< isSteered() of the path as planned; smoothing may change isSteered()
};

/// A solution from start to goal: straight motions between consecutive points. Always delivered with its certificate.
struct Path {
  std::vector<PathPoint> points;
  MotionCertificate certificate;

  std::vector<Pose> configurations() const;
  double length() const;    ///< sum of translations, metres
  double rotation() const;  ///< sum of rotation angles, radians
  /// Metric length of the segments by author, metres.
  PerAuthor<double> lengthByAuthor(const Se3Metric& metric) const;
};

}  // namespace glissade
