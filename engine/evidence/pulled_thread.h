#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/stop_token.h"
#include "engine/evidence/named_screw.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// An assembled pair of bodies, one of which leaves the other.
struct LeavingPair {
  const PlacedBody& moving;
  const PlacedBody& other;
  double overlap = 0.0;                   ///< metres, as deep as the one is in the other
  bool isCalledThread = false;            ///< by the file: also where both cylinders are equally wide
  const ScrewInSolid* inSolid = nullptr;  ///< one is a screw that makes its hole in the other one; null: none is
  std::string nameOfMoving{};             ///< may say that a body is a screw of a size, a nut or a pin
  std::string nameOfOther{};
};

/// Two cylinders that are around each other where the product is assembled: about one axis, or about two beside each
/// other with all of the hole's wall in the shaft. The crests of a modelled thread stand for a cylinder. World frame.
struct CommonThread {
  Vector3 point;
  Vector3 axis;
  double depth;   ///< excess of the shaft over the hole, metres
  double radius;  ///< radius of the shaft
  double low;     ///< range of the moving body's cylinder, along the axis from `point`
  double high;
  double lowOther;
  double highOther;
  bool movingIsShaft;
  double pitch = 0.0;  ///< metres a turn, of a helix that is modelled; below 0: left-handed; 0: none is
};

/// Limits in radii of the shaft. The threads of ISO 261 are deeper than the first, and none is deeper than the second.
/// The bodies overlap by at least half of that depth, or one cylinder is around the material of the other body.
inline constexpr double kLeastThreadDepth = 0.05;
inline constexpr double kMostThreadDepth = 0.3;

/// True if the core of a standard thread is this much thinner than a shaft of this radius, metres: the hole is drawn as
/// the core. Fine threads of large diameters are less deep than kLeastThreadDepth. What is pressed in is not thicker by
/// more than a third of a millimetre. An overlap that is as deep as a clash has a coarse pitch, or a fine one with
/// the depth of the standard: the fine pitches of a large diameter together suit almost every depth.
bool isCoreOfThread(double radius, double depth);

/// True if a shaft is thicker than its hole by what a thread is deep: by 0.2 coarse pitches or more, since a hole is
/// drawn as the core of the thread (0.54 pitches by ISO 68-1), as its tap drill (0.5) or with its pitch diameter
/// (0.32), or as isCoreOfThread() says. A shaft that is less thick is pressed in, or is a spline. Metres.
bool hasDepthOfThread(double radius, double depth);

/// The threads that the pair has in common, which come apart by turning: a shaft of the one in a hole of the other,
/// with all of the hole's wall in the shaft; crests of a modelled helix that go into the wall of the other one; and
/// crests that are rings, where a name says that the body is a screw of this size; and a nut on a shaft that is as wide
/// as its hole (drawn_nut.h). The one definition of what may not
/// be pulled: planners ask for it while they make a motion, and the judge when it judges one. Not all after a stop.
std::vector<CommonThread> commonThreads(const LeavingPair& pair, const StopToken& stop = {});

/// Describes how much of the threads a motion pulls instead of turning the body off, for people; empty: nothing. While
/// the two cylinders are engaged, the body turns about the axis and advances by the same pitch in each turn. The last
/// pitch may be pulled, because a thread ends in its run-out. `path`: of the moving body, from its assembled pose.
Message pulledThread(const std::vector<CommonThread>& threads, const std::vector<Pose>& path);

/// True if an assembled shaft of one body is thicker than the hole of the other that contains it, by an excess that can
/// be pressed in.
bool isPressedIn(const PlacedBody& one, const PlacedBody& other);

/// True if the guest is an insert in a hole of the host: a small ring that is thicker than the hole, or a body whose
/// name says that it is an insert or a bearing (`isNamed`) and that is as wide as the hole, or thicker.
bool isInsertIn(const PlacedBody& guest, const PlacedBody& host, bool isNamed);

/// A thread in which a motion turns.
struct TurnedThread {
  double pitch = 0.0;     ///< metres a turn of the motion; below 0: left-handed
  double diameter = 0.0;  ///< of the shaft, metres
  double modelled = 0.0;  ///< as CommonThread::pitch
};
std::vector<TurnedThread> turnedThreads(const std::vector<CommonThread>& threads, const std::vector<Pose>& path);

/// A shaft of one body in a hole of the other one that is narrower by what can be a thread or a press fit.
struct RoundOverlap {
  double depth = 0.0;   ///< the largest excess of a shaft, metres; 0: there is none
  double radius = 0.0;  ///< of that shaft
};
RoundOverlap roundOverlap(const PlacedBody& one, const PlacedBody& other);

}  // namespace glissade::evidence
