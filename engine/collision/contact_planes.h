#pragma once

#include <optional>
#include <vector>

#include "engine/collision/collision_query.h"

namespace glissade {

/// A small motion of the object.
struct SmallMotion {
  Vector3 translation = Vector3::Zero();  ///< metres
  Vector3 rotation = Vector3::Zero();     ///< radians, rotation vector about the reference point, world frame
};

Pose moved(const Pose& q, const SmallMotion& motion);
/// No point of the object moves farther between a and b.
double longestWay(const Pose& a, const Pose& b, double radius);

/// The tangent planes that the object has met lately, and the motions that they leave (the constraints of the
/// god-object in six degrees of freedom, Ortega et al. 2007). What was learnt far from where the object is now is
/// forgotten.
class ContactPlanes {
 public:
  /// Lengths in metres.
  struct Rule {
    double radius;  ///< of the object
    double gap;     ///< kept at every contact
    double memory;  ///< contacts learnt farther away (longestWay()) are forgotten
    /// A radian counts as much as this way: the shorter, the more the object turns. Nothing: it does not turn.
    std::optional<double> turning;
  };
  explicit ContactPlanes(const Rule& rule) : rule_(rule) {}

  void clear() { contacts_.clear(); }
  bool empty() const { return contacts_.empty(); }
  /// The nearest obstacle of the object at q. Ignored where there is none, or where it is not at a distance.
  void learn(const Pose& q, const NearestObstacle& nearest);
  void forgetFarFrom(const Pose& q);
  /// The nearest motion to the requested one that keeps the contact gap at every contact: projected Gauss-Seidel. A
  /// plane that is met beside the middle of the object turns it, so that a face comes to lie flat.
  SmallMotion along(const Pose& q, const SmallMotion& requested) const;

 private:
  /// A tangent plane of an obstacle and the point of the object that touches it.
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
