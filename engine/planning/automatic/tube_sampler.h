#pragma once

#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"

namespace glissade {

/// Configurations about a path: a point of it, moved normally distributed in every direction. One in
/// ten is uniform, for what the path did not foresee.
class TubeSampler final : public ConfigurationSampler {
 public:
  /// `deviation` in metres of the metric, for each direction.
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
  std::vector<double> lengths_;  ///< up to each point
};

/// `q` moved by a translation and a turn about the object's reference point, both normally
/// distributed, the turn so that its farthest point moves as much; inside the bounds.
Pose perturbed(const Pose& q, double deviation, double radius, const Box3& bounds, RandomStream& stream);

}  // namespace glissade
