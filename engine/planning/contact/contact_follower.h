#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/random_stream.h"
#include "engine/collision/contact_planes.h"
#include "engine/planning/contact/contact_sampler.h"
#include "engine/planning/operator_sample.h"

namespace glissade {

/// Contact sampling that follows surfaces, which paper 1 names as its next step (section V): from one contact to the
/// next, along several planes in sequence, with an orientation that follows from the contacts.
///
/// Every other sample is the paper's, on the plane that the hand is near (ContactSampler), because such samples lead
/// past the ends of surfaces. The others are ends of legs on the surfaces. The first leg begins where the hand would
/// touch and continues the hand's motion. Half of the later legs begin there, too, and half at the end of the leg
/// before, in random directions. Half of the legs keep the orientation. The object is pressed against the plane that it
/// touches, and a contact away from its middle turns it. So a face comes to lie flat, an edge rolls over, and two
/// planes guide the object along their line (ContactPlanes). Every configuration on the way is retracted to the gap by
/// the measured distance. A leg ends where it meets another plane, so that the straight motion between two samples lies
/// on a surface.
class ContactFollower {
 public:
  ContactFollower(double objectRadius, std::uint64_t seed);

  /// Begins at the hand. `gap`: distance kept to the surfaces, metres. `longest`: longest leg, metres. Precondition:
  /// operatorSample.nearest.distance > 0.
  void enter(const OperatorSample& operatorSample, double gap, double longest);
  /// The next sample. At the end of a leg, half of the gap or more is free.
  Pose sample(CollisionQuery& query);

 private:
  /// A configuration in which the object is pressed against a plane.
  struct Place {
    Pose q;
    NearestObstacle nearest;  ///< nearest obstacle at q, moved with the object to the gap
  };

  Place pressed(const Pose& q, const NearestObstacle& nearest) const;
  Pose leg(CollisionQuery& query);
  Vector3 nextDirection(const Vector3& normal_W);
  double step(double length, CollisionQuery& query);

  double radius_;
  RandomStream stream_;
  ContactSampler plane_;
  ContactPlanes planes_;
  std::optional<Vector3> device_;  ///< position of the hand at the last enter()
  Place hand_;                     ///< place where the hand would touch
  Place at_;
  Vector3 way_ = Vector3::Zero();  ///< unit direction of the leg; zero: the next leg draws one
  double gap_ = 0.0;
  double longest_ = 0.0;
  int queries_ = 0;       ///< distance queries of the leg
  int drawn_ = 0;         ///< samples since enter()
  bool returns_ = false;  ///< the next leg begins at the hand
};

}  // namespace glissade
