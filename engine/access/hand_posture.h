#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/access/hand_measures.h"
#include "engine/geometry/pose.h"

namespace glissade {

// The frame H of a hand: the wrist is at the origin, z points to the fingers, x out of the palm, y to the thumb. It is
// a right hand.

/// A finger or the thumb: balls at its joints and its tip, and what lies between them.
struct Digit {
  struct Joint {
    Vector3 p_H;
    double radius;
  };
  std::vector<Joint> joints;  ///< the one at the hand first
};

/// How fingers and thumb are held.
struct HandPosture {
  std::array<Digit, 5> digits;  ///< the thumb, then index to little finger
  /// The frame of the grip: its origin is between the pads, z points from the hand into what is gripped, x from the
  /// fingers to the thumb.
  Pose X_HG;
  double room = 0.0;  ///< metres between the grip and the palm, along z of the grip
};

/// What a pinch is like.
struct Pinch {
  double opening = 0.0;  ///< metres between the pads
  int fingers = 4;       ///< against the thumb, the index finger first: 1, 2 or 4; the others are closed
  double tilt = 0.0;     ///< radians between the hand's z and the direction into what is gripped
};

/// Tilts that are tried, radians: at ease, and with stretched fingers, which reach deeper.
inline constexpr double kPinchTilts[] = {0.87, 1.40};

/// Thumb against fingers. Nothing where the hand does not open so far.
std::optional<HandPosture> pinchPosture(const HandMeasures& hand, const Pinch& pinch);

/// A fist about a bar of this diameter, along y through the origin of the grip.
HandPosture fistPosture(const HandMeasures& hand, double diameter);

/// The index finger stretched, the others closed: the grip's origin is at its tip.
HandPosture pointingPosture(const HandMeasures& hand);

/// Bends of the wrist that are tried, the ones at ease first: the frame of the forearm in the hand's, with the wrist at
/// its origin and the elbow along -z. All are within what most people reach: 50 degrees back, 35 to the palm, 15 to
/// the thumb, 25 to the little finger.
const std::vector<Pose>& wristBends();

}  // namespace glissade
