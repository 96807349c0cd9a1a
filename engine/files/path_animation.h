#pragma once

#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// A configuration at a time of an animation.
struct KeyFrame {
  float time;  ///< time in seconds
  Pose q;
};

/// A path as an animation of that many seconds at constant speed in the metric.
///
/// An edge is interpolate(): linear in position, the short great arc in orientation, at one parameter. A player that
/// interpolates key frames so (glTF's LINEAR) moves exactly on the path with key frames at its configurations. Edges
/// with large turns have additional key frames, for players that interpolate the components of quaternions, and because
/// rounding would choose the sense of rotation near half a turn.
///
/// Consecutive quaternions lie in one hemisphere. Times begin at 0 and increase strictly, by at least a microsecond,
/// even between equal configurations. Precondition: a configuration; 0 < seconds < 16, so that single precision holds
/// that microsecond.
std::vector<KeyFrame> keyFramesOf(const std::vector<Pose>& path, const Se3Metric& metric, double seconds);

}  // namespace glissade
