#pragma once

#include <memory>

#include "engine/planning/automatic/configuration_sampler.h"
#include "engine/planning/automatic/eroded_worlds.h"

namespace glissade {

/// Configurations in contact. A uniform one is brought to the surface: a colliding one retracted by
/// means of the eroded object, a free one nearby moved up to it. Then every other one is turned so
/// that one of the object's large faces lies on the contact's plane, and every other one slides: on
/// that plane until something is in the way, then along both planes' common line n1 x n2 until a third
/// is (paper 1, section VI, names both as future work). Half of the draws stay uniform.
class ContactSlideSampler final : public ConfigurationSampler {
 public:
  /// `depth` is that of the erosion, `gap` what is kept of a surface in contact; metres.
  ContactSlideSampler(const Problem& problem, std::uint64_t seed, ErodedWorlds& worlds, double depth, double gap);

  Pose draw() override;

  /// The configuration in contact nearest to q, more or less; nothing where there is no surface near.
  std::optional<Pose> toSurface(const Pose& q);
  /// Turned so that the large face that is nearest to it lies on the plane with unit normal n_W (from
  /// the obstacle to the object).
  Pose aligned(const Pose& q, const Vector3& n_W) const;
  /// Slid in contact from q: on the plane of the nearest obstacle, then along the line of two.
  Pose slid(const Pose& q);

 private:
  bool isFree(const Pose& q);
  Pose walked(const Pose& from, const Vector3& direction, double length);
  Vector3 tangentTo(const Vector3& n_W);

  UniformSampler uniform_;
  RandomStream stream_;
  Box3 bounds_;
  double radius_;
  double depth_;
  double gap_;
  std::unique_ptr<CollisionQuery> query_;
  std::unique_ptr<CollisionQuery> eroded_;
  std::vector<Vector3> faces_B_;
};

}  // namespace glissade
