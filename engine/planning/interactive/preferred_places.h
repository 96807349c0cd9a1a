#pragma once

#include <memory>

#include "engine/planning/automatic/configuration_sampler.h"

namespace glissade {

/// The cells of the places that a person prefers (semantic attribute "preference" above 1), in one region. Like
/// WayBoard, it is published between the rounds of a portfolio and read by its members during the rounds.
class PreferredPlaces {
 public:
  /// The region; null while no place is preferred.
  const SamplingRegionPtr& current() const { return region_; }
  const Box3& bounds() const { return bounds_; }
  /// Takes over changed edits (null: none). Without knowledge of the problem's places none is preferred.
  void follow(const Problem& problem, const SemanticEditsPtr& edits);

 private:
  SemanticEditsPtr edits_;
  SamplingRegionPtr region_;
  Box3 bounds_;  ///< of the problem
};

/// Draws from the preferred places for a member: one draw in five has its position there. While none is preferred it
/// draws as the member's own sampler, and no random number is used up.
class PreferredSampler final : public ConfigurationSampler {
 public:
  static constexpr double kShare = 0.2;

  PreferredSampler(std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
                   std::shared_ptr<const PreferredPlaces> places)
      : own_(std::move(own)), stream_(seed, "preferred places"), places_(std::move(places)) {}

  Pose draw(const Box3& tree) override;
  Author author() const override { return drawnByOwn_ ? own_->author() : Author::Computer; }
  void grew(const Pose& q, CollisionQuery& query) override { own_->grew(q, query); }

 private:
  std::unique_ptr<ConfigurationSampler> own_;
  RandomStream stream_;
  std::shared_ptr<const PreferredPlaces> places_;
  bool drawnByOwn_ = true;  ///< the own sampler made the last draw
};

}  // namespace glissade
