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
  /// Of the straight motion that ends here: of the node that it was made for, that is of the later one
  /// of its two ends. Not always `author`: a path runs up the goal tree from child to parent.
  Author segmentAuthor = Author::Computer;
};

std::vector<Pose> configurationsOf(const std::vector<PathPoint>& points);

/// A person has led a part of the way: configurations that a hand showed, or in contact about the object in the hand.
bool isSteered(const std::vector<PathPoint>& points);

/// The run that a path comes from.
struct PathProvenance {
  std::string planner;  ///< its id; empty: unknown
  std::uint64_t seed = 0;
  bool steered = false;  ///< as isSteered() of the path as planned, which smoothing changes
};

/// A solution from start to goal: straight motions between consecutive points. Only ever delivered
/// together with its certificate.
struct Path {
  std::vector<PathPoint> points;
  MotionCertificate certificate;

  std::vector<Pose> configurations() const;
  double length() const;    ///< sum of translations, metres
  double rotation() const;  ///< sum of rotation angles, radians
  /// Metric length of the segments of each author, metres.
  PerAuthor<double> lengthByAuthor(const Se3Metric& metric) const;
};

}  // namespace glissade
