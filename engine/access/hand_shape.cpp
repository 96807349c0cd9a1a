#include "engine/access/hand_shape.h"

#include <cmath>
#include <numbers>

#include "engine/access/loft.h"

namespace glissade {
namespace {

/// Half axes of an ellipse, by its circumference and the ratio of its axes (Ramanujan's formula).
struct Ellipse {
  Ellipse(double circumference, double ratio)
      : wide(circumference /
             (std::numbers::pi * (3.0 * (1.0 + ratio) - std::sqrt((3.0 + ratio) * (1.0 + 3.0 * ratio))))),
        thick(ratio * wide) {}
  double wide;
  double thick;
};

Ellipse wristOf(const HandMeasures& hand) { return {hand.wristCircumference, 0.7}; }

/// An ellipse across z: x is the thickness, y the breadth.
LoftRing ringAt(double z, double thick, double wide) { return {{0.0, 0.0, z}, {thick, 0.0, 0.0}, {0.0, wide, 0.0}}; }

TriangleMesh palmShape(const HandMeasures& hand) {
  const Ellipse wrist = wristOf(hand);
  const double B = hand.handBreadth;
  const double T = hand.handThickness();
  const double L = hand.palmLength;
  return loft({ringAt(-0.06 * L, 0.75 * wrist.thick, 0.75 * wrist.wide), ringAt(0.0, 0.95 * wrist.thick, wrist.wide),
               ringAt(0.14 * L, 0.52 * T, 0.41 * B), ringAt(0.4 * L, 0.52 * T, 0.46 * B),
               ringAt(0.65 * L, 0.5 * T, 0.49 * B), ringAt(0.82 * L, 0.44 * T, 0.5 * B),
               ringAt(0.92 * L, 0.34 * T, 0.46 * B), ringAt(0.98 * L, 0.18 * T, 0.36 * B)});
}

}  // namespace

TriangleMesh handShape(const HandMeasures& hand, const HandPosture& posture) {
  TriangleMesh mesh = palmShape(hand);
  for (const Digit& digit : posture.digits) {
    for (std::size_t i = 0; i + 1 < digit.joints.size(); ++i) {
      const Digit::Joint& from = digit.joints[i];
      const Digit::Joint& to = digit.joints[i + 1];
      append(mesh, taperedLimb(from.p_H, from.radius, to.p_H, to.radius));
    }
  }
  return mesh;
}

TriangleMesh forearmShape(const HandMeasures& hand) {
  const Ellipse wrist = wristOf(hand);
  const Ellipse most(hand.forearmCircumference, 0.85);
  const double L = hand.forearmLength();
  // Shares of the length from the wrist, and of the change from the wrist's section to the widest one.
  const auto ring = [&](double along, double share) {
    return ringAt(-along * L, wrist.thick + share * (most.thick - wrist.thick),
                  wrist.wide + share * (most.wide - wrist.wide));
  };
  const auto elbow = [&](double along, double share) {
    return ringAt(-along * L, share * most.thick, share * most.wide);
  };
  return loft({elbow(1.0, 0.2), elbow(0.993, 0.42), elbow(0.978, 0.6), elbow(0.955, 0.75), elbow(0.92, 0.86),
               elbow(0.87, 0.94), ring(0.8, 0.99), ring(0.7, 0.98), ring(0.6, 0.88), ring(0.5, 0.7), ring(0.4, 0.48),
               ring(0.3, 0.28), ring(0.2, 0.13), ring(0.1, 0.04), ring(0.0, 0.0),
               ringAt(0.04 * L, 0.8 * wrist.thick, 0.8 * wrist.wide)});
}

}  // namespace glissade
