#pragma once

#include <memory>

#include "engine/planning/automatic/configuration_sampler.h"

namespace glissade {

/// The cells of the places that a person prefers (semantic attribute "preference" above 1), in one region. Published
/// between the rounds of a portfolio, read by its members within them, as WayBoard is.
class PreferredPlaces {
 public:
  /// Null while none is preferred.
  const SamplingRegionPtr& current() const { return region_; }
  /// Looks at the edits, where they are others than the last time (null: none). Without knowledge of the problem's
  /// places none is preferred.
  void follow(const Problem& problem, const SemanticEditsPtr& edits);

 private:
  SemanticEditsPtr edits_;
  SamplingRegionPtr region_;
};

/// A member's share in the places that are preferred: one draw in five has its position there. While none is preferred
/// it draws as its own sampler, and no random number is used up.
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
  bool drawnByOwn_ = true;  ///< the last one
};

}  // namespace glissade
