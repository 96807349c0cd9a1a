#include "engine/fits/pressed_joints.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/fits/nut_on_shaft.h"
#include "engine/fits/shaft_helix.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// Share of the radius within which the cylinders of hole and guest decide, instead of their slabs.
constexpr double kClearPress = 0.02;
/// Cylinders within this distance fit exactly, metres, as in contacts of a product.
constexpr double kExactFit = 3e-6;
/// A ring without other evidence is an insert if it is thicker than its hole by no more than this share of its radius,
/// as what is pressed in, or as small as inserts for plastic and sheet metal, metres. A larger one may be a threaded
/// cap.
constexpr double kMostPressed = 0.01;
constexpr double kLargestInsert = 8e-3;
constexpr double kPinClearance = 1.06;
/// Metres, radial: a body thicker than its hole by more is not pressed in. Inserts in warm plastic are thicker by 0.8
/// mm. A guest whose name says that it is an insert may have no hole at all.
constexpr double kMostExcess = 1.5e-3;
/// Least share of the guest's length in its host, for a press and for an exact fit.
constexpr double kPressedShare = 0.2;
constexpr double kFittedShare = 0.4;
constexpr double kHostReach = 1.6;
/// The host extends beyond its guest by so many times what the triangles of both may be off, or, where no file states
/// that, by this share of the guest's radius.
constexpr double kBeyondDeflections = 2.0;
constexpr double kThickerHost = 0.02;
/// Share of the radius up to which the cylinders of guest and hole are compared.
constexpr double kComparedCylinders = 2.0 * kClearPress;
/// Least ratio of the host's hole to that of its guest.
constexpr double kLeastOfBore = 0.9;
constexpr double kLeastHostAround = 0.6;
/// Weaker limits for a guest whose name says that it is an insert: it may be at an edge, or be misplaced.
constexpr double kLeastNamedAround = 0.35;
constexpr double kNamedShare = 0.1;
/// Limits of the ratio of length to radius of a pin.
constexpr double kShortestPin = 1.5;
constexpr double kLongestPin = 20.0;
constexpr double kCoaxialShare = 0.05;

/// The fit of a guest in a hole of another body.
struct HostFit {
  std::size_t host = 0;
  double over = 0.0;    ///< length in which the guest is thicker than the hole, metres
  double equal = 0.0;   ///< length in which they are equal, metres
  double excess = 0.0;  ///< largest radial excess of the guest, metres
  double low = 0.0;     ///< range along the axis of the guest
  double high = 0.0;
};

/// True if the excess is that of a thread: shafts are pressed in by hundredths of their radius, and screwed in by half
/// of a pitch and more.
bool hasDepthOfCoarseThread(double radius, double excess) {
  constexpr double kLeast = 0.3;
  constexpr double kMost = 0.8;
  const double inPitches = excess / coarsePitch(radius).pitch;
  return isThreadDepth(radius, excess) && inPitches >= kLeast && inPitches <= kMost;
}

double outerAt(const TurnedShape& shape, double height) {
  for (const AxialSlab& slab : shape.slabs) {
    if (height >= slab.low && height <= slab.high) return slab.outerMost();
  }
  return 0.0;
}

/// True for a round shaft, which can turn in a round hole; false for a square body.
bool hasRoundShaft(const TurnedShape& shape) {
  constexpr double kLeastRoundPin = 0.9;
  constexpr double kRoundShare = 0.8;
  double round = 0.0;
  for (const AxialSlab& slab : shape.slabs) {
    if (slab.high <= shape.headLow && slab.outerLeast() >= kLeastRoundPin * slab.outerMost()) round += slab.length();
  }
  return round >= kRoundShare * (shape.headLow - shape.low);
}

/// Share of the directions in which the surrounding body extends beyond this radius.
double shareBeyond(const AxialSlab& slab, double radius) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < slab.nearest.size(); ++i) {
    const bool isOpen = slab.farthest[i] > 0.0 && slab.farthest[i] <= slab.nearest[i];
    beyond += isOpen || slab.farthest[i] > radius ? 1U : 0U;
  }
  return static_cast<double>(beyond) / static_cast<double>(slab.nearest.size());
}

class PressedJointFinder {
 public:
  PressedJointFinder(const ProductShapes& shapes, const Joints& threaded, const Designations& said,
                     const StopToken& stop)
      : shapes_(shapes), said_(said), stop_(stop) {
    for (std::size_t body = 0; body < said.size(); ++body) {
      isInsertByName_.push_back(says(said, body, {StandardPart::Insert, StandardPart::Bearing}));
    }
    for (const Joint& joint : threaded) {
      threaded_.insert(joint.body);
      for (const std::size_t other : joint.others) {
        if (joint.kind == JointKind::Screw) hasThread_.insert(other);
        if (joint.kind == JointKind::Nut) threaded_.insert(other);
      }
    }
  }

  Joints find() {
    Joints joints;
    for (std::size_t body = 0; body < shapes_.size() && !stop_.stopRequested(); ++body) {
      const TurnedShape* shape = shapes_.turned(body);
      if (shape == nullptr || threaded_.count(body) != 0) continue;
      const bool isRing = shape->kind == TurnedKind::Ring || (shape->kind == TurnedKind::Nut && isInsertByName_[body]);
      if (isRing) addRing(body, *shape, joints);
      if (shape->kind == TurnedKind::Rod || shape->kind == TurnedKind::Screw) addPin(body, *shape, joints);
    }
    return joints;
  }

 private:
  std::vector<HostFit> hostsOf(std::size_t guest, const TurnedShape& shape) const {
    const AxisLine axis = shapes_.axisOf(guest);
    std::vector<HostFit> hosts;
    for (const std::size_t body : shapes_.near(axis, {shape.low, shape.high, shape.outer}, guest)) {
      if (isSolidFastener(body)) continue;
      auto fit = fitIn(body, guest, shape, axis);
      if (fit.over + fit.equal > 0.0) hosts.push_back(fit);
    }
    return hosts;
  }

  /// True for screws, rods and possible nuts, which have no pressed rings.
  bool isSolidFastener(std::size_t body) const {
    const TurnedShape* shape = shapes_.turned(body);
    return shape != nullptr && shape->kind != TurnedKind::Ring;
  }

  /// True if the body may have a pin: a plate with a hole may, a nut may not.
  bool mayHavePin(std::size_t body) const {
    const TurnedShape* shape = shapes_.turned(body);
    const bool isPlate = shape != nullptr && shape->kind == TurnedKind::Nut && !isNut(shapes_, said_, body);
    return isPlate || !isSolidFastener(body);
  }

  HostFit fitIn(std::size_t host, std::size_t guest, const TurnedShape& shape, const AxisLine& axis) const {
    HostFit fit{host};
    fit.low = shape.high;
    fit.high = shape.low;
    const AxisLine seen = shapes_.seenFrom(host, axis);
    const double leastAround = isInsertByName_[guest] ? kLeastNamedAround : kLeastHostAround;
    const double beyond = beyondGuest(host, guest, shape.outer);
    double unsure = 0.0;
    for (const AxialSlab& slab :
         shapes_.axial(host).slabsAbout(seen, {shape.low, shape.high, kHostReach * shape.outer})) {
      const double outer = outerAt(shape, 0.5 * (slab.low + slab.high));
      if (slab.surroundedShare() < leastAround && !(slab.isSolid && slab.surroundedShare() == 0.0)) continue;
      const bool isIn = slab.isSolid && (slab.surroundedShare() == 0.0 || slab.nearestAt(0.3) > outer);
      const double hole = slab.isSolid ? (isIn ? 0.0 : kHostReach * shape.outer) : slab.nearestAt(0.9);
      const bool isAround = slab.isSolid || shareBeyond(slab, outer + beyond) >= leastAround;
      if (!isAround || hole > (1.0 + kClearPress) * outer) continue;
      const bool isOver = hole < (1.0 - kClearPress) * outer;
      if (outer - hole > kMostExcess && !isInsertByName_[guest]) continue;
      // A body that is also in the hole of the guest is no host around it; a name may say that no hole is drawn.
      if (isOver && hole < kLeastOfBore * shape.hole && !isInsertByName_[guest]) continue;
      if (isOver && !isFilled(host, seen, slab, 0.5 * (std::max(hole, shape.hole) + outer))) continue;
      fit.low = std::min(fit.low, slab.low);
      fit.high = std::max(fit.high, slab.high);
      if (!isOver) {
        unsure += slab.length();
        continue;
      }
      fit.over += slab.length();
      fit.excess = std::max(fit.excess, outer - hole);
    }
    if (unsure > 0.0) compareCylinders(host, guest, unsure, fit);
    return fit;
  }

  double beyondGuest(std::size_t host, std::size_t guest, double outer) const {
    const std::vector<double>& deflections = shapes_.product().deflections;
    const double off = kBeyondDeflections * (deflections[host] + deflections[guest]);
    return off > 0.0 ? std::min(off, kThickerHost * outer) : kThickerHost * outer;
  }

  /// True if the host also fills the volume of the guest, not only its hole or its surroundings.
  bool isFilled(std::size_t host, const AxisLine& seen, const AxialSlab& slab, double radius) const {
    constexpr double kFilledShare = 0.3;
    return shapes_.axial(host).filledShare(seen, 0.5 * (slab.low + slab.high), radius) >= kFilledShare;
  }

  /// Compares the coaxial cylinders of both that are beside each other, exactly.
  void compareCylinders(std::size_t host, std::size_t guest, double length, HostFit& fit) const {
    double least = kComparedCylinders * shapes_.turned(guest)->outer;
    for (const CylinderRegion& shaft : shapes_.cylindersOf(guest)) {
      if (!shaft.shaft) continue;
      const AxisLine axis{shaft.point, shaft.direction};
      for (const CylinderRegion& hole : shapes_.cylindersOf(host)) {
        if (hole.shaft || !isSameAxis(axis, {hole.point, hole.direction}, kCoaxialShare * shaft.radius)) continue;
        const double middle = axis.heightOf(hole.point + 0.5 * (hole.low + hole.high) * hole.direction);
        const double half = 0.5 * (hole.high - hole.low);
        if (middle + half <= shaft.low || middle - half >= shaft.high) continue;
        if (std::abs(hole.radius - shaft.radius) <= std::abs(least)) least = hole.radius - shaft.radius;
      }
    }
    if (least < -kExactFit) {
      fit.over += length;
      fit.excess = std::max(fit.excess, -least);
    } else if (least <= kExactFit) {
      fit.equal += length;
    }
  }

  void addRing(std::size_t body, const TurnedShape& shape, Joints& joints) const {
    if (!isInsertByName_[body] && wrenchFlats(shape)) return;  // it is screwed in
    const std::vector<HostFit> hosts = hostsOf(body, shape);
    const HostFit* best = nullptr;
    for (const HostFit& fit : hosts) {
      const double share = isInsertByName_[body] ? kNamedShare : kPressedShare;
      const bool isPressed = fit.over >= share * shape.length();
      const bool isFitted = fit.over + fit.equal >= kFittedShare * shape.length() &&
                            (isInsertByName_[body] || hasThread_.count(body) != 0);
      if (!isPressed && !isFitted) continue;
      if (best == nullptr || fit.over > best->over || (fit.over == best->over && fit.equal > best->equal)) best = &fit;
    }
    if (best == nullptr) return;
    Joint joint = jointOf(JointKind::Insert, body, {*best}, shapes_.axisOf(body));
    joint.evidence = {GLISSADE_TEXT("a ring in a hole"), fitWords(*best)};
    if (hasThread_.count(body) != 0) joint.evidence.emplace_back(GLISSADE_TEXT("a thread is in it"));
    if (!isEvident(body, shape, best->excess)) {
      joint.state = JointState::Suggested;
      joint.isDoubtful = true;
      joint.evidence.emplace_back(GLISSADE_TEXT("it is larger than inserts are, and may be screwed in"));
    }
    joints.push_back(std::move(joint));
  }

  /// True if a ring that is thicker than its hole by this excess is pressed in, or is an insert by its name, its knurl,
  /// its size or the thread in it.
  bool isEvident(std::size_t body, const TurnedShape& shape, double excess) const {
    return isInsertByName_[body] || hasThread_.count(body) != 0 || excess <= kMostPressed * shape.outer ||
           shape.outer <= kLargestInsert || hasTeeth(shape);
  }

  void addPin(std::size_t body, const TurnedShape& shape, Joints& joints) const {
    // A screw in a hole that it only passes is no pin.
    if (shape.kind == TurnedKind::Screw && isScrewByItself(shapes_, said_, body)) return;
    if (!hasRoundShaft(shape)) return;
    const double below = shape.headLow - shape.low;
    if (below < kShortestPin * shape.shaft || below > kLongestPin * shape.shaft) return;
    TurnedShape shaft = shape;
    shaft.high = shape.headLow;
    shaft.outer = shape.shaft;
    const AxisLine axis = shapes_.axisOf(body);
    std::vector<HostFit> pressed;
    std::vector<HostFit> loose;
    for (const std::size_t other : shapes_.near(axis, {shape.low, shape.headLow, shape.shaft}, body)) {
      if (!mayHavePin(other)) continue;
      const auto around = aroundShaft(shapes_.axial(other), shapes_.seenFrom(other, axis), shaft);
      if (!around || around->hole > kPinClearance * shape.shaft) continue;
      if (shape.shaft - around->hole > kMostExcess && !isInsertByName_[body]) continue;
      HostFit fit = fitIn(other, body, shaft, axis);
      fit.low = around->low;
      fit.high = around->high;
      const bool isPressed = fit.over >= std::min(kPressedShare * below, 0.5 * shape.shaft);
      (isPressed ? pressed : loose).push_back(fit);
    }
    if (!pressed.empty()) {
      const auto deepest = std::max_element(pressed.begin(), pressed.end(),
                                            [](const auto& a, const auto& b) { return a.over < b.over; });
      const bool isPinByName = isInsertByName_[body] || says(said_, body, {StandardPart::Pin});
      const bool isScrewedIn = !isPinByName && hasDepthOfCoarseThread(shape.shaft, deepest->excess);
      if (isScrewedIn || modelledPitch(shapes_.axial(body), shape)) return;
      Joint joint = jointOf(JointKind::Insert, body, {*deepest}, axis);
      joint.evidence = {GLISSADE_TEXT("a pin in a hole"), fitWords(*deepest)};
      if (hasDepthOfCoarseThread(shape.shaft, deepest->excess)) {
        joint.isDoubtful = true;
        joint.evidence.emplace_back(GLISSADE_TEXT("it is thicker by as much as a thread"));
      }
      joints.push_back(std::move(joint));
      return;
    }
    if (loose.empty()) return;
    Joint joint = jointOf(JointKind::Pin, body, loose, axis);
    joint.direction = wayOut(shape, loose, axis);
    joint.evidence.push_back({GLISSADE_TEXT("a shaft of %1 in a hole"), {Length{2.0 * shape.shaft}}});
    joints.push_back(std::move(joint));
  }

  /// The exit direction: towards the head, else to the side on which the pin leaves the holes sooner.
  static Vector3 wayOut(const TurnedShape& shape, const std::vector<HostFit>& hosts, const AxisLine& axis) {
    if (shape.kind == TurnedKind::Screw) return axis.direction;
    double low = hosts.front().low;
    double high = hosts.front().high;
    for (const HostFit& host : hosts) {
      low = std::min(low, host.low);
      high = std::max(high, host.high);
    }
    const bool isUp = high - shape.low <= shape.high - low;
    return isUp ? axis.direction : Vector3(-axis.direction);
  }

  static Joint jointOf(JointKind kind, std::size_t body, const std::vector<HostFit>& hosts, const AxisLine& axis) {
    Joint joint;
    joint.kind = kind;
    joint.body = body;
    for (const HostFit& host : hosts) joint.others.push_back(host.host);
    joint.point = axis.point;
    joint.direction = axis.direction;
    return joint;
  }

  /// Diameters are compared.
  static Message fitWords(const HostFit& fit) {
    if (fit.excess > 0.0) return {GLISSADE_TEXT("it is %1 thicker than its hole"), {Length{2.0 * fit.excess}}};
    return GLISSADE_TEXT("it is as wide as its hole");
  }

  const ProductShapes& shapes_;
  const Designations& said_;
  std::vector<bool> isInsertByName_;
  const StopToken& stop_;
  std::set<std::size_t> threaded_;   ///< screws, nuts and the shafts of nuts
  std::set<std::size_t> hasThread_;  ///< bodies that screws are in
};

}  // namespace

Joints findPressedJoints(const ProductShapes& shapes, const Joints& threaded, const Designations& said,
                         const StopToken& stop) {
  return PressedJointFinder(shapes, threaded, said, stop).find();
}

}  // namespace glissade
