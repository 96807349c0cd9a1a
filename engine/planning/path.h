#pragma once

#include <vector>

#include "engine/collision/motion_certificate.h"
#include "engine/planning/roadmap.h"

namespace glissade {

struct PathPoint {
  Pose q;
  Author author = Author::Computer;
};

/// A solution from start to goal: straight motions between consecutive points. Only ever delivered
/// together with its certificate.
struct Path {
  std::vector<PathPoint> points;
  MotionCertificate certificate;

  std::vector<Pose> configurations() const;
  double length() const;    ///< sum of translations, metres
  double rotation() const;  ///< sum of rotation angles, radians
};

}  // namespace glissade
