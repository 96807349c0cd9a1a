#pragma once

#include "engine/planning/random_shooter.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// Draws the configurations that trees grow towards.
class ConfigurationSampler {
 public:
  virtual ~ConfigurationSampler() = default;
  /// `tree`: bounding box of the positions of the tree that is to grow.
  virtual Pose draw(const Box3& tree) = 0;
  /// Author of the configuration that was drawn last.
  virtual Author author() const { return Author::Computer; }
  /// A tree has a new node. `query` is the planner's own query, so that its use counts as the planner's work.
  virtual void grew(const Pose& /*q*/, CollisionQuery& /*query*/) {}
};

/// Draws uniformly in the problem's region or bounds.
class UniformSampler final : public ConfigurationSampler {
 public:
  UniformSampler(const Problem& problem, std::uint64_t seed) : shooter_(problem, seed) {}
  Pose draw(const Box3& /*tree*/) override { return shooter_.shoot(); }

 private:
  RandomShooter shooter_;
};

}  // namespace glissade
