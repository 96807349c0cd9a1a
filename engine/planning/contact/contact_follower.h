#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/random_stream.h"
#include "engine/collision/contact_planes.h"
#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/operator_sample.h"

namespace glissade {

/// Contact sampling that follows surfaces, which paper 1 names as its next step (section V): from one contact to the
/// next, along several planes one after the other, the orientation left to the contacts.
///
/// Every other sample is the paper's, on the plane that the hand is near (ContactSampler): such samples lead past the
/// ends of surfaces. The others are ends of legs on the surfaces. The first leg begins where the hand would touch and
/// goes the way that the hand has gone; of the others, half begin there, too, and half where the last one has ended, in
/// random directions. Half of the legs keep the orientation. The object is
/// pressed against the plane it touches: what it meets beside its middle turns it, so that a face comes to lie flat, an
/// edge rolls over, and two planes guide it along their line (ContactPlanes). Every configuration on the way is
/// retracted to the gap by the distance that is measured there. A leg ends where another plane is met, so that the
/// straight motion between two samples lies on a surface.
class ContactFollower {
 public:
  ContactFollower(double objectRadius, std::uint64_t seed);

  /// Begins at the hand. `gap`: kept to the surfaces; `longest`: of a leg; metres. Precondition:
  /// operatorSample.nearest.distance > 0.
  void enter(const OperatorSample& operatorSample, double gap, double longest);
  /// The next sample. At the end of a leg, half of the gap or more is free.
  Pose sample(CollisionQuery& query);

 private:
  /// Where the object is pressed against a plane.
  struct Place {
    Pose q;
    NearestObstacle nearest;  ///< of q, moved along with the object to the gap
  };

  Place pressed(const Pose& q, const NearestObstacle& nearest) const;
  Pose leg(CollisionQuery& query);
  Vector3 nextDirection(const Vector3& normal_W);
  double step(double length, CollisionQuery& query);

  double radius_;
  RandomStream stream_;
  ContactSampler plane_;
  ContactPlanes planes_;
  std::optional<Vector3> device_;  ///< position of the hand when it was entered last
  Place hand_;                     ///< where the hand would touch
  Place at_;
  Vector3 way_ = Vector3::Zero();  ///< unit, of the leg; zero: the next leg draws one
  double gap_ = 0.0;
  double longest_ = 0.0;
  int queries_ = 0;       ///< distances that the leg has asked for
  int drawn_ = 0;         ///< samples since enter()
  bool returns_ = false;  ///< the next leg begins at the hand
};

}  // namespace glissade
