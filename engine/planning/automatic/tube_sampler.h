#pragma once

#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"

namespace glissade {

/// Draws configurations about a path: a point of the path, moved by a normal distribution in every direction. One draw
/// in ten is uniform, for places that the path misses.
class TubeSampler final : public ConfigurationSampler {
 public:
  /// `deviation`: standard deviation for each direction, metres of the metric.
  TubeSampler(const Problem& problem, std::vector<Pose> path, double deviation, std::uint64_t seed);
  Pose draw(const Box3& tree) override;

 private:
  Pose onPath();

  UniformSampler uniform_;
  RandomStream stream_;
  Box3 bounds_;
  double radius_;
  double deviation_;
  std::vector<Pose> path_;
  std::vector<double> lengths_;  ///< length of the path up to each point
};

/// `q` moved by a translation and a turn about the object's reference point, both normally distributed, and kept inside
/// the bounds. The turn moves the object's farthest point as much as the translation does.
Pose perturbed(const Pose& q, double deviation, double radius, const Box3& bounds, RandomStream& stream);

}  // namespace glissade
