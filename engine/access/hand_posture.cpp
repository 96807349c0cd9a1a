#include "engine/access/hand_posture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kStretched = 0.98;  ///< share of its length to which a digit may be stretched

/// Bends of a finger that is closed into the palm.
constexpr std::array<double, 3> kClosed{85.0 * kDegree, 100.0 * kDegree, 60.0 * kDegree};

/// Base and length of a finger, as shares of the palm's breadth and length, and of the middle finger.
struct FingerShape {
  double across;
  double along;
  double length;
};
constexpr std::array<FingerShape, 4> kFingers{
    {{0.375, 0.87, 0.92}, {0.125, 0.88, 1.0}, {-0.125, 0.85, 0.93}, {-0.375, 0.80, 0.75}}};
/// Lengths of the three phalanges, as shares of a finger.
constexpr std::array<double, 3> kPhalanges{0.47, 0.29, 0.24};
constexpr double kMiddleKnuckle = 0.88;  ///< share of the palm's length

/// Lengths of one hand, from its measures.
struct HandParts {
  explicit HandParts(const HandMeasures& measures)
      : hand(measures),
        thickness(measures.handThickness()),
        finger(measures.handLength - kMiddleKnuckle * measures.palmLength) {}

  Vector3 knuckle(const FingerShape& shape) const {
    return {0.0, shape.across * hand.handBreadth, shape.along * hand.palmLength};
  }
  double phalanx(const FingerShape& shape, std::size_t i) const { return kPhalanges[i] * shape.length * finger; }
  /// Distance from the last joint to the centre of the ball at the tip.
  double lastPhalanx(const FingerShape& shape) const { return phalanx(shape, 2) - tipRadius(); }
  double knuckleRadius() const { return 0.115 * hand.handBreadth; }
  double jointRadius() const { return 0.105 * hand.handBreadth; }
  double tipRadius() const { return 0.085 * hand.handBreadth; }
  Vector3 thumbBase() const { return {0.2 * thickness, 0.30 * hand.handBreadth, 0.18 * hand.palmLength}; }
  double thumbRadius() const { return 0.11 * hand.handBreadth; }
  double metacarpal() const { return 0.42 * hand.palmLength; }
  double thumbProximal() const { return 0.28 * hand.palmLength; }
  double thumbDistal() const { return 0.24 * hand.palmLength - thumbRadius(); }

  const HandMeasures& hand;
  double thickness;
  double finger;
};

/// The joint between two links of these lengths, towards the pole. A target out of reach is replaced by the nearest
/// reachable one.
Vector3 elbow(const Vector3& base, const Vector3& target, double first, double second, const Vector3& pole) {
  const Vector3 way = (target - base).normalized();
  const double distance = std::clamp((target - base).norm(), std::abs(first - second) + 1e-6, first + second - 1e-6);
  const double along = (distance * distance + first * first - second * second) / (2.0 * distance);
  const Vector3 aside = (pole - pole.dot(way) * way).normalized();
  return base + along * way + std::sqrt(std::max(0.0, first * first - along * along)) * aside;
}

/// A finger with its tip at this point, bent away from the surface that it touches.
Digit reachingFinger(const HandParts& parts, const FingerShape& shape, const Vector3& tip, const Vector3& outwards) {
  const Vector3 knuckle = parts.knuckle(shape);
  const double middle = parts.phalanx(shape, 1);
  const double last = parts.lastPhalanx(shape);
  const Vector3 first = elbow(knuckle, tip, parts.phalanx(shape, 0), middle + last, outwards);
  const Vector3 second = first + (middle / (middle + last)) * (tip - first) + 0.06 * (middle + last) * outwards;
  return {{{knuckle, parts.knuckleRadius()},
           {first, parts.jointRadius()},
           {second, 0.95 * parts.jointRadius()},
           {tip, parts.tipRadius()}}};
}

/// A finger whose joints are bent towards the palm by these angles, radians.
Digit bentFinger(const HandParts& parts, const FingerShape& shape, const std::array<double, 3>& bends) {
  Vector3 at = parts.knuckle(shape);
  Digit digit{{{at, parts.knuckleRadius()}}};
  double angle = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    angle += bends[i];
    const double length = i == 2 ? parts.lastPhalanx(shape) : parts.phalanx(shape, i);
    at += length * Vector3(std::sin(angle), 0.0, std::cos(angle));
    digit.joints.push_back({at, i == 2 ? parts.tipRadius() : parts.jointRadius()});
  }
  return digit;
}

Digit reachingThumb(const HandParts& parts, const Vector3& tip, const Vector3& outwards) {
  const Vector3 base = parts.thumbBase();
  const double rest = parts.thumbProximal() + parts.thumbDistal();
  const Vector3 first = elbow(base, tip, parts.metacarpal(), rest, outwards);
  const Vector3 second = first + (parts.thumbProximal() / rest) * (tip - first) + 0.05 * rest * outwards;
  return {{{base, 0.19 * parts.hand.handBreadth},
           {first, 0.13 * parts.hand.handBreadth},
           {second, parts.thumbRadius()},
           {tip, 0.95 * parts.thumbRadius()}}};
}

/// The directions of a pinch in the hand's frame.
struct PinchFrame {
  explicit PinchFrame(double tilt)
      : into(std::sin(tilt), 0.0, std::cos(tilt)), toThumb(std::cos(tilt), 0.0, -std::sin(tilt)) {}
  Vector3 into;
  Vector3 toThumb;
};

bool reaches(const Vector3& base, const Vector3& target, double length) {
  return (target - base).norm() <= kStretched * length;
}

double fingerLength(const HandParts& parts, const FingerShape& shape) {
  return parts.phalanx(shape, 0) + parts.phalanx(shape, 1) + parts.lastPhalanx(shape);
}

/// The tips of one pinch, for a distance of the grip from the palm.
struct PinchTips {
  Vector3 finger(const FingerShape& shape, double reach) const {
    Vector3 tip = palm + reach * frame.into - (0.5 * pinch.opening + parts.tipRadius()) * frame.toThumb;
    tip.y() = shape.across * parts.hand.handBreadth;
    return tip;
  }
  Vector3 thumb(double reach) const {
    return palm + reach * frame.into + (0.5 * pinch.opening + 0.95 * parts.thumbRadius()) * frame.toThumb;
  }
  bool fingerReaches(const FingerShape& shape, double reach) const {
    return reaches(parts.knuckle(shape), finger(shape, reach), fingerLength(parts, shape));
  }
  bool thumbReaches(double reach) const {
    const double length = parts.metacarpal() + parts.thumbProximal() + parts.thumbDistal();
    return reaches(parts.thumbBase(), thumb(reach), length);
  }

  const HandParts& parts;
  const Pinch& pinch;
  PinchFrame frame;
  Vector3 palm;  ///< point under the leading pads
};

constexpr double kReachStep = 0.001;

/// The farthest reach of thumb, index and middle finger together, or of thumb and index finger; nothing if it is too
/// near to the palm.
std::optional<double> farthestReach(const PinchTips& tips) {
  const double least = 0.22 * tips.parts.hand.handLength;
  for (double reach = tips.parts.hand.handLength; reach >= least; reach -= kReachStep) {
    const bool middle = tips.pinch.fingers == 1 || tips.fingerReaches(kFingers[1], reach);
    if (tips.thumbReaches(reach) && tips.fingerReaches(kFingers[0], reach) && middle) {
      return reach;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<HandPosture> pinchPosture(const HandMeasures& hand, const Pinch& pinch) {
  const HandParts parts(hand);
  const PinchFrame frame(pinch.tilt);
  const double across = pinch.fingers == 1 ? kFingers[0].across : 0.5 * (kFingers[0].across + kFingers[1].across);
  const PinchTips tips{parts, pinch, frame, {0.0, across * hand.handBreadth, 0.6 * hand.palmLength}};
  const auto reach = farthestReach(tips);
  if (!reach) return std::nullopt;
  HandPosture posture;
  posture.digits[0] = reachingThumb(parts, tips.thumb(*reach), (frame.toThumb - 0.5 * frame.into).normalized());
  for (std::size_t i = 0; i < kFingers.size(); ++i) {
    const FingerShape& shape = kFingers[i];
    if (i >= static_cast<std::size_t>(pinch.fingers)) {
      posture.digits[i + 1] = bentFinger(parts, shape, kClosed);
      continue;
    }
    double own = *reach;
    while (own > 0.0 && !tips.fingerReaches(shape, own)) own -= kReachStep;
    posture.digits[i + 1] = reachingFinger(parts, shape, tips.finger(shape, own), -frame.toThumb);
  }
  Eigen::Matrix3d axes;
  axes << frame.toThumb, frame.into.cross(frame.toThumb), frame.into;
  posture.X_HG = {tips.palm + *reach * frame.into, Quaternion(axes)};
  posture.room = *reach - 0.55 * parts.thickness / std::sin(pinch.tilt);
  return posture;
}

HandPosture fistPosture(const HandMeasures& hand, double diameter) {
  const HandParts parts(hand);
  constexpr double kOpen = 0.06;  ///< diameter at which a fist is half open, metres
  const double open = std::clamp(diameter / kOpen, 0.0, 1.0);
  HandPosture posture;
  for (std::size_t i = 0; i < kFingers.size(); ++i) {
    posture.digits[i + 1] =
        bentFinger(parts, kFingers[i],
                   {(82.0 - 25.0 * open) * kDegree, (100.0 - 30.0 * open) * kDegree, (65.0 - 20.0 * open) * kDegree});
  }
  const Vector3 bar(0.5 * parts.thickness + 0.5 * diameter, 0.0, 0.84 * hand.palmLength);
  const Vector3 tip = bar + Vector3(0.5 * diameter + 2.2 * parts.jointRadius(), 0.30 * hand.handBreadth, 0.0);
  posture.digits[0] = reachingThumb(parts, tip, Vector3(0.3, 1.0, 0.0).normalized());
  Eigen::Matrix3d axes;
  axes << -Vector3::UnitZ(), Vector3::UnitY(), Vector3::UnitX();
  posture.X_HG = {bar, Quaternion(axes)};
  return posture;
}

HandPosture pointingPosture(const HandMeasures& hand) {
  const HandParts parts(hand);
  const PinchFrame frame(40.0 * kDegree);
  HandPosture posture;
  const Vector3 tip = parts.knuckle(kFingers[0]) + kStretched * fingerLength(parts, kFingers[0]) * frame.into;
  posture.digits[1] = reachingFinger(parts, kFingers[0], tip, -frame.toThumb);
  for (std::size_t i = 1; i < kFingers.size(); ++i) posture.digits[i + 1] = bentFinger(parts, kFingers[i], kClosed);
  const Vector3 atRest(0.5 * parts.thickness + 3.2 * parts.jointRadius(), 0.2 * hand.handBreadth,
                       0.75 * hand.palmLength);
  posture.digits[0] = reachingThumb(parts, atRest, Vector3(0.3, 1.0, 0.0).normalized());
  Eigen::Matrix3d axes;
  axes << frame.toThumb, frame.into.cross(frame.toThumb), frame.into;
  posture.X_HG = {tip + parts.tipRadius() * frame.into, Quaternion(axes)};
  return posture;
}

const std::vector<Pose>& wristBends() {
  static const std::vector<Pose> bends = [] {
    std::vector<Pose> all;
    // Bends to the back and to the thumb, degrees.
    for (const auto& [back, aside] :
         {std::pair{25.0, 0.0}, {50.0, 0.0}, {0.0, 0.0}, {-35.0, 0.0}, {25.0, 15.0}, {25.0, -25.0}}) {
      Pose bend;
      bend.orientation = Quaternion(Eigen::AngleAxisd(back * kDegree, Vector3::UnitY())) *
                         Quaternion(Eigen::AngleAxisd(aside * kDegree, Vector3::UnitX()));
      all.push_back(bend);
    }
    return all;
  }();
  return bends;
}

}  // namespace glissade
