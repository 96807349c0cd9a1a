#pragma once

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/interactive/shown_way.h"

namespace glissade {

/// Draws configurations for a member, a share of them from the hand's way. A number a from [0, 1) is drawn as in line 3
/// of Algorithm 1 (paper 1). The computer's own sampler draws for a at or below its share. Else the configuration is
/// from the tube about the hand's way: a point of it, moved at random. Where that point is nearer to an obstacle than
/// d, N of N + 1 such draws are on the tangent plane there. One draw in ten is ahead of the hand, in the direction in
/// which it pushes. Nodes of the member that are nearer than d have N draws on their tangent plane, too; one node in
/// fifty is tested. While nothing is shown it draws as the member's own sampler, and no random number is used up.
class WaySampler final : public ConfigurationSampler {
 public:
  /// `slides`: the member's trees go on in contact.
  WaySampler(const Problem& problem, std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
             std::shared_ptr<const WayBoard> board, bool slides);

  Pose draw(const Box3& tree) override;
  /// Operator for draws about the hand's way and ahead of the hand, Contact for draws on the tangent plane at a point
  /// of the way.
  Author author() const override { return author_; }
  void grew(const Pose& q, CollisionQuery& query) override;

 private:
  Pose fromTube(const ShownWay& way);
  Pose ahead(const ShownWay& way);
  Pose inside(Pose q) const;

  std::unique_ptr<ConfigurationSampler> own_;
  RandomStream stream_;
  ContactSampler contactSampler_;
  ContactSampler ownContact_;  ///< sampler at nodes of the member
  int ownContactSamplesLeft_ = 0;
  std::shared_ptr<const WayBoard> board_;
  Box3 bounds_;
  double radius_;
  bool slides_;
  Author author_ = Author::Computer;
};

}  // namespace glissade
