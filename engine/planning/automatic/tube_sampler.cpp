#include "engine/planning/automatic/tube_sampler.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr double kUniformShare = 0.1;

Vector3 normalVector(RandomStream& stream, double deviation) {
  const double x = stream.normal();
  const double y = stream.normal();
  const double z = stream.normal();
  return deviation * Vector3(x, y, z);
}

}  // namespace

Pose perturbed(const Pose& q, double deviation, double radius, const Box3& bounds, RandomStream& stream) {
  Pose result = q;
  result.position += normalVector(stream, deviation);
  result.position = result.position.cwiseMax(bounds.min()).cwiseMin(bounds.max());
  const Vector3 turn = normalVector(stream, deviation / radius);
  const double angle = turn.norm();
  if (angle > 0.0) {
    result.orientation = (Quaternion(Eigen::AngleAxisd(angle, turn / angle)) * q.orientation).normalized();
  }
  return result;
}

TubeSampler::TubeSampler(const Problem& problem, std::vector<Pose> path, double deviation, std::uint64_t seed)
    : uniform_(problem, seed),
      stream_(seed, "tube"),
      bounds_(problem.bounds),
      radius_(problem.world->objectRadius()),
      deviation_(deviation),
      path_(std::move(path)) {
  const Se3Metric metric = problem.metric();
  lengths_.push_back(0.0);
  for (std::size_t i = 1; i < path_.size(); ++i) {
    lengths_.push_back(lengths_.back() + metric.distance(path_[i - 1], path_[i]));
  }
}

Pose TubeSampler::draw(const Box3& tree) {
  if (stream_.uniform() < kUniformShare) return uniform_.draw(tree);
  return perturbed(onPath(), deviation_, radius_, bounds_, stream_);
}

Pose TubeSampler::onPath() {
  const double s = stream_.uniform() * lengths_.back();
  const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), s);
  if (after == lengths_.end()) return path_.back();
  const auto i = static_cast<std::size_t>(after - lengths_.begin());
  return interpolate(path_[i - 1], path_[i], (s - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]));
}

}  // namespace glissade
