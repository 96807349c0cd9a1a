#pragma once

#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"

namespace glissade {

/// Draws for trees in an assembly. The first ones are uniform, which finds what is open. Later ones explore where the
/// tree has got to: a share of the positions is uniform in the box of the tree, half a radius of the object beyond it,
/// and a quarter of the orientations are those of the start or of the goal, because parts mostly leave along several
/// directions without being turned. In a workspace that is much larger than the passages, uniform draws only pull at
/// the ends of the tree. The box is what A. Yershova et al., "Dynamic-domain RRTs: efficient exploration by
/// controlling the sampling domain" (2005), have per node, here per tree.
class AssemblySampler final : public ConfigurationSampler {
 public:
  /// Draws of a life that are uniform.
  static constexpr int kUniform = 500;

  /// `nearShare`: of the later positions, that are in the box of the tree; 0 where the problem has a region.
  AssemblySampler(const Problem& problem, std::uint64_t seed, double nearShare);
  Pose draw(const Box3& tree) override;

 private:
  Vector3 near(const Box3& tree);

  UniformSampler uniform_;
  RandomStream stream_;
  Box3 bounds_;
  std::vector<Quaternion> orientations_;  ///< of the start and, where it is a configuration, the goal
  double nearShare_;
  double margin_;  ///< beyond the box, metres
  int drawn_ = 0;
};

}  // namespace glissade
