#include "engine/files/path_animation.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr float kLeastTime = 1e-6F;  ///< least time between key frames, seconds
/// Largest turn between key frames, radians. Interpolation by components then has an error of at most 4e-5.
constexpr double kLargestTurn = 0.2;

/// The path with normalized quaternions, because files may round them.
std::vector<Pose> normalized(std::vector<Pose> path) {
  for (Pose& q : path) q.orientation.normalize();
  return path;
}

/// The path with configurations added on edges with large turns.
std::vector<Pose> withTurnsDivided(const std::vector<Pose>& path) {
  std::vector<Pose> divided{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double turn = angleBetween(path[i - 1].orientation, path[i].orientation);
    const int parts = std::max(1, static_cast<int>(std::ceil(turn / kLargestTurn)));
    for (int part = 1; part <= parts; ++part) {
      divided.push_back(interpolate(path[i - 1], path[i], static_cast<double>(part) / parts));
    }
  }
  return divided;
}

void bringIntoOneHemisphere(std::vector<Pose>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i - 1].orientation.dot(path[i].orientation) < 0.0) path[i].orientation.coeffs() *= -1.0;
  }
}

/// Metric length from the start to each configuration.
std::vector<double> lengthsAlong(const std::vector<Pose>& path, const Se3Metric& metric) {
  std::vector<double> lengths{0.0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    lengths.push_back(lengths.back() + metric.distance(path[i - 1], path[i]));
  }
  return lengths;
}

}  // namespace

std::vector<KeyFrame> keyFramesOf(const std::vector<Pose>& path, const Se3Metric& metric, double seconds) {
  std::vector<Pose> poses = withTurnsDivided(normalized(path));
  bringIntoOneHemisphere(poses);
  const std::vector<double> lengths = lengthsAlong(poses, metric);
  const double pace = lengths.back() > 0.0 ? seconds / lengths.back() : 0.0;
  std::vector<KeyFrame> frames{{0.0F, poses.front()}};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto time = static_cast<float>(lengths[i] * pace);
    frames.push_back({std::max(time, frames.back().time + kLeastTime), poses[i]});
  }
  return frames;
}

}  // namespace glissade
