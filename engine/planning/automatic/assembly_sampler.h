#pragma once

#include <vector>

#include "engine/planning/automatic/configuration_sampler.h"

namespace glissade {

/// Sampler for trees in an assembly. The first draws are uniform, for open space. Later draws follow the tree: a share
/// of the positions is uniform in the box of the tree, extended by half a radius of the object, and a quarter of the
/// orientations are those of the start or of the goal, because parts mostly leave along several directions without
/// being turned. In a workspace that is much larger than the passages, uniform draws extend only the outermost nodes of
/// the tree. The box applies the idea of A. Yershova et al., "Dynamic-domain RRTs: efficient exploration by controlling
/// the sampling domain" (2005), to the whole tree instead of to each node.
class AssemblySampler final : public ConfigurationSampler {
 public:
  /// Number of uniform draws at the beginning of a life.
  static constexpr int kUniform = 500;

  /// `nearShare`: share of the later positions that are drawn in the box of the tree; 0 where the problem has a region.
  AssemblySampler(const Problem& problem, std::uint64_t seed, double nearShare);
  Pose draw(const Box3& tree) override;

 private:
  Vector3 near(const Box3& tree);

  UniformSampler uniform_;
  RandomStream stream_;
  Box3 bounds_;
  std::vector<Quaternion> orientations_;  ///< orientations of the start and, where it is a configuration, of the goal
  double nearShare_;
  double margin_;  ///< margin about the tree's box, metres
  int drawn_ = 0;
};

}  // namespace glissade
