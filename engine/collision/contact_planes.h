#pragma once

#include <optional>
#include <vector>

#include "engine/collision/collision_query.h"

namespace glissade {

/// A small motion of the object.
struct SmallMotion {
  Vector3 translation = Vector3::Zero();  ///< translation of the reference point, metres
  Vector3 rotation = Vector3::Zero();     ///< radians, rotation vector about the reference point, world frame
};

Pose moved(const Pose& q, const SmallMotion& motion);
/// Upper bound of the motion of any point of the object between a and b.
double longestWay(const Pose& a, const Pose& b, double radius);

/// The tangent planes of recent contacts, and the motions that they permit (the constraints of the god-object in six
/// degrees of freedom, Ortega et al. 2007). Contacts that were learnt far from the present configuration are forgotten.
class ContactPlanes {
 public:
  /// Parameters; lengths in metres.
  struct Rule {
    double radius;  ///< radius of the object
    double gap;     ///< gap kept at every contact
    double memory;  ///< contacts learnt farther away (longestWay()) are forgotten
    /// Translation that counts as much as a turn of one radian: the shorter, the more the object turns. Nothing: it
    /// does not turn.
    std::optional<double> turning;
  };
  explicit ContactPlanes(const Rule& rule) : rule_(rule) {}

  void clear() { contacts_.clear(); }
  bool empty() const { return contacts_.empty(); }
  /// Adds the nearest obstacle of the object at q. Ignored where there is none, or where its distance is 0.
  void learn(const Pose& q, const NearestObstacle& nearest);
  void forgetFarFrom(const Pose& q);
  /// The nearest motion to the requested one that keeps the contact gap at every contact: projected Gauss-Seidel. A
  /// plane that is touched away from the middle of the object turns it, so that a face comes to lie flat.
  SmallMotion along(const Pose& q, const SmallMotion& requested) const;

 private:
  /// A tangent plane of an obstacle, and the point of the object that touches it.
  struct Contact {
    Pose learntAt;
    Vector3 p_WPo;
    Vector3 normal_W;
    Vector3 p_BPn;
  };

  Rule rule_;
  std::vector<Contact> contacts_;
};

}  // namespace glissade
