#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/access/hand_measures.h"
#include "engine/geometry/pose.h"

namespace glissade {

// The frame H of a right hand: the wrist is at the origin, z points to the fingers, x out of the palm, y to the thumb.

/// A finger or the thumb: balls at its joints and its tip, and the limbs between them.
struct Digit {
  struct Joint {
    Vector3 p_H;
    double radius;
  };
  std::vector<Joint> joints;  ///< joints, from the hand to the tip
};

/// The posture of fingers and thumb.
struct HandPosture {
  std::array<Digit, 5> digits;  ///< the thumb, then index to little finger
  /// The frame of the grip: its origin is between the pads, z points from the hand into the gripped body, x from the
  /// fingers to the thumb.
  Pose X_HG;
  double room = 0.0;  ///< distance between the grip and the palm along z of the grip, metres
};

/// The parameters of a pinch.
struct Pinch {
  double opening = 0.0;  ///< metres between the pads
  int fingers = 4;       ///< fingers against the thumb, the index finger first: 1, 2 or 4; the others are closed
  double tilt = 0.0;     ///< angle between the hand's z and the direction into the gripped body, radians
};

/// Tilts that are tried, radians: relaxed, and with stretched fingers, which reach deeper.
inline constexpr double kPinchTilts[] = {0.87, 1.40};

/// A pinch of the thumb against fingers. Nothing if the hand does not open that far.
std::optional<HandPosture> pinchPosture(const HandMeasures& hand, const Pinch& pinch);

/// A fist about a bar of this diameter, along y through the origin of the grip.
HandPosture fistPosture(const HandMeasures& hand, double diameter);

/// The index finger stretched, the others closed: the origin of the grip is at its tip.
HandPosture pointingPosture(const HandMeasures& hand);

/// Bends of the wrist that are tried, the relaxed ones first: the frame of the forearm in the hand's frame, with the
/// wrist at its origin and the elbow along -z. All are within the range of most people: 50 degrees back, 35 to the
/// palm, 15 to the thumb, 25 to the little finger.
const std::vector<Pose>& wristBends();

}  // namespace glissade
