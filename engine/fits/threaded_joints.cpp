#include "engine/fits/threaded_joints.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/fits/loose_nut.h"
#include "engine/fits/nut_on_shaft.h"
#include "engine/fits/shaft_helix.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// Largest ratios of a hole to its shaft: drawn as wide as the outer thread, or wider than a drawn core.
constexpr double kMostFreeGap = 1.3;
constexpr double kClearerHole = 1.03;
/// Largest distance of the axes of a nut and its shaft, in radii.
constexpr double kSameAxisShare = 0.15;
/// Least engaged length of a thread, in radii of the shaft.
constexpr double kLeastEngaged = 0.15;
/// Least share of a nut's height that is on its shaft.
constexpr double kOnShaft = 0.5;
/// Limits of the ratio of a rod to the hole of its nut.
constexpr double kThinnestRod = 0.7;
constexpr double kThickestRod = 1.45;

/// Limits of the sine of the angle between a shaft and a tilted hole.
constexpr double kLeastTilt = 0.02;
constexpr double kMostTilt = 0.5;

/// The bodies along the shaft of a screw, and those that have its thread.
struct ScrewStack {
  std::vector<AroundShaft> hosts;    ///< the nearest to the head first
  std::vector<AroundShaft> clamped;  ///< the nearest to the head first
  Message reason;                    ///< reason why the hosts count as hosts
  Message doubt;                     ///< evidence against it; empty: none
  bool isDeepened = false;           ///< a hole is narrower by a thread
};

/// A contradictory joint waits for a person, unless the hole is narrower by a thread.
void addDoubt(const Message& doubt, bool isDeepened, Joint& joint) {
  if (doubt.empty()) return;
  joint.isDoubtful = true;
  joint.evidence.push_back(doubt);
  if (!isDeepened) joint.state = JointState::Suggested;
}

class ThreadedJointFinder {
 public:
  ThreadedJointFinder(const ProductShapes& shapes, const Designations& said, const StopToken& stop)
      : shapes_(shapes), said_(said), stop_(stop) {}

  Joints find() {
    Joints joints;
    for (std::size_t body = 0; body < shapes_.size() && !stop_.stopRequested(); ++body) {
      const TurnedShape* shape = shapes_.turned(body);
      if (shape == nullptr) continue;
      if (shape->kind == TurnedKind::Screw || shape->kind == TurnedKind::SetScrew) addScrew(body, *shape, joints);
    }
    for (std::size_t body = 0; body < shapes_.size() && !stop_.stopRequested(); ++body) {
      if (nutsTaken_.count(body) == 0 && isNut(shapes_, said_, body)) addNutOnRod(body, *shapes_.turned(body), joints);
    }
    return joints;
  }

 private:
  bool isScrew(std::size_t body) const { return isScrewByItself(shapes_, said_, body); }

  bool isNutOn(std::size_t body, const AxisLine& axis, double radius) const {
    return isNut(shapes_, said_, body) && isSameAxis(shapes_.axisOf(body), axis, kSameAxisShare * radius);
  }

  /// True for another screw in the same place with its head at the same end, which is a variant of it.
  bool isTwin(std::size_t body, const AxisLine& axis, double radius) const {
    const TurnedShape* shape = shapes_.turned(body);
    if (shape == nullptr || shape->kind != TurnedKind::Screw) return false;
    const AxisLine other = shapes_.axisOf(body);
    return isSameAxis(other, axis, kSameAxisShare * radius) && other.direction.dot(axis.direction) > 0.0;
  }

  /// takeNuts() has examined nuts. Bearings, washers and rings have no thread, however wide their holes are.
  bool mayHaveThread(std::size_t body) const {
    return !isNut(shapes_, said_, body) &&
           !says(said_, body, {StandardPart::Bearing, StandardPart::Washer, StandardPart::Ring, StandardPart::Seal});
  }

  std::vector<AroundShaft> allAround(std::size_t screw, const TurnedShape& shape) const {
    const AxisLine axis = shapes_.axisOf(screw);
    std::vector<AroundShaft> all;
    for (const std::size_t body : shapes_.near(axis, {shape.low, shape.headLow, shape.shaft}, screw)) {
      if (isTwin(body, axis, shape.shaft)) continue;
      auto around = aroundShaft(shapes_.axial(body), shapes_.seenFrom(body, axis), shape);
      if (!around) continue;
      around->body = body;
      all.push_back(*around);
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.high > b.high; });
    return all;
  }

  ScrewStack stackOf(const std::vector<AroundShaft>& all, std::size_t body, const TurnedShape& shape) const {
    ScrewStack stack;
    takeTight(all, body, shape, stack);
    if (stack.hosts.empty()) takeNuts(all, body, shape, stack);
    if (stack.hosts.empty() && isScrew(body)) takeDeepestHole(all, body, shape, stack);
    if (!stack.hosts.empty()) takeClamped(all, shape, stack);
    return stack;
  }

  /// Holes that are narrower by a thread. A body without a hole, or with a far narrower one, says nothing of a shaft
  /// that is no screw.
  void takeTight(const std::vector<AroundShaft>& all, std::size_t body, const TurnedShape& shape,
                 ScrewStack& stack) const {
    if (hasTeeth(shape) && !isScrew(body)) return;
    for (const AroundShaft& around : all) {
      const double tight = isScrew(body) ? around.tight : around.threaded;
      if (tight < kLeastEngaged * shape.shaft) continue;
      if (isTilted(around.body, shapes_.axisOf(body), shape)) continue;
      if (isNutOn(around.body, shapes_.axisOf(body), shape.shaft)) {
        stack.doubt = nutOnShaft(shapes_, said_, {around.body, body, shape.shaft, isScrew(body)}).doubt;
      }
      stack.hosts.push_back(around);
    }
    stack.reason = GLISSADE_TEXT("the shaft is thicker than the hole");
    stack.isDeepened = !stack.hosts.empty();
  }

  /// True if the hole around the shaft is wide enough, and tilted against it.
  bool isTilted(std::size_t host, const AxisLine& axis, const TurnedShape& shape) const {
    const std::vector<CylinderRegion> cylinders = shapes_.cylindersOf(host);
    return std::any_of(cylinders.begin(), cylinders.end(), [&](const CylinderRegion& hole) {
      const Vector3 middle = hole.point + 0.5 * (hole.low + hole.high) * hole.direction;
      const double height = axis.heightOf(middle);
      const double sine = hole.direction.cross(axis.direction).norm();
      return !hole.shaft && sine > kLeastTilt && sine < kMostTilt && axis.distanceOf(middle) < 0.5 * shape.shaft &&
             height > shape.low && height < shape.headLow && !isThreadDepth(shape.shaft, shape.shaft - hole.radius) &&
             hole.radius < kAroundReach * shape.shaft;
    });
  }

  void takeNuts(const std::vector<AroundShaft>& all, std::size_t body, const TurnedShape& shape,
                ScrewStack& stack) const {
    for (const AroundShaft& around : all) {
      if (!isNutOn(around.body, shapes_.axisOf(body), shape.shaft)) continue;
      const NutOnShaft nut = nutOnShaft(shapes_, said_, {around.body, body, shape.shaft, isScrew(body)});
      if (!nut.isThread) continue;
      stack.doubt = nut.doubt;
      stack.reason = GLISSADE_TEXT("a nut is on the shaft");
      stack.hosts.push_back(around);
    }
  }

  /// Takes the hole farthest from the head, among holes that are drawn as wide as the shaft or wider.
  void takeDeepestHole(std::vector<AroundShaft> all, std::size_t body, const TurnedShape& shape,
                       ScrewStack& stack) const {
    std::erase_if(all, [&](const AroundShaft& each) { return !mayHaveThread(each.body); });
    if (all.empty()) return;
    const std::string name = shapes_.product().nameInFile(body);
    if (says(said_, body, {StandardPart::Pin}) || isShaftName(name)) {
      stack.doubt = {GLISSADE_TEXT("the name says '%1'"), {name}};
    }
    const double least = kLeastEngaged * shape.shaft;
    for (auto around = all.rbegin(); around != all.rend(); ++around) {
      if (around->equal < least) continue;
      stack.hosts.push_back(*around);
      stack.reason = GLISSADE_TEXT("the hole is as wide as the shaft, and the farthest from the head");
      return;
    }
    const AroundShaft& last = all.back();
    if (last.hole > kMostFreeGap * shape.shaft) return;
    // Washers and spacers are around the shaft, whatever their width.
    const auto isWiderOrRing = [&](const AroundShaft& other) {
      const TurnedShape* turned = shapes_.turned(other.body);
      const bool isRing = turned != nullptr && turned->kind == TurnedKind::Ring;
      return isRing || other.hole > kClearerHole * last.hole;
    };
    const bool isNarrowest = all.size() > 1 && std::all_of(all.begin(), all.end() - 1, isWiderOrRing);
    if (!isNarrowest && !last.isBlind) return;
    stack.hosts.push_back(last);
    stack.reason = GLISSADE_TEXT("the hole is the narrowest, and the farthest from the head");
  }

  /// Takes the bodies that the head, or a washer below it, does not pass.
  static void takeClamped(const std::vector<AroundShaft>& all, const TurnedShape& shape, ScrewStack& stack) {
    double cover = shape.outer;
    const double end = stack.hosts.back().low;
    for (const AroundShaft& around : all) {
      const bool isHost = std::any_of(stack.hosts.begin(), stack.hosts.end(),
                                      [&](const AroundShaft& host) { return host.body == around.body; });
      if (isHost || around.hole > 0.99 * cover || around.high <= end) continue;
      stack.clamped.push_back(around);
    }
  }

  JointThread threadOf(const ScrewStack& stack, std::size_t body, const TurnedShape& shape) const {
    JointThread thread;
    thread.diameter = 2.0 * shape.shaft;
    thread.pitch = pitchOfHole(shape.shaft, stack.hosts.front().hole);
    if (const auto pitch = modelledPitch(shapes_.axial(body), shape)) {
      thread.pitch = *pitch;
      thread.isPitchStated = true;
    }
    double top = shape.low;
    for (const AroundShaft& host : stack.hosts) {
      const bool isFitted = host.tight + host.equal > 0.0;
      thread.engaged = std::max(thread.engaged, isFitted ? host.tight + host.equal : host.surround);
      top = std::max(top, isFitted ? host.tightHigh : host.high);
    }
    thread.travel = std::clamp(top - shape.low, 0.0, shape.headLow - shape.low);
    thread.engaged = std::min(thread.engaged, thread.travel);
    return thread;
  }

  void addScrew(std::size_t body, const TurnedShape& shape, Joints& joints) {
    const AxisLine axis = shapes_.axisOf(body);
    const ScrewStack stack = stackOf(allAround(body, shape), body, shape);
    if (stack.hosts.empty()) return;
    Joint joint;
    joint.kind = JointKind::Screw;
    joint.body = body;
    for (const AroundShaft& host : stack.hosts) joint.others.push_back(host.body);
    for (const AroundShaft& around : stack.clamped) joint.clamped.push_back(around.body);
    joint.point = axis.point + shape.headLow * axis.direction;
    joint.direction = axis.direction;
    joint.thread = threadOf(stack, body, shape);
    joint.drive = shape.drive.kind;
    joint.driveSize = shape.drive.size;
    const CatalogueText shaft = shape.kind == TurnedKind::Screw ? GLISSADE_TEXT("a shaft of %1 with a head")
                                                                : GLISSADE_TEXT("a shaft of %1 with a recess");
    joint.evidence.push_back({shaft, {Length{2.0 * shape.shaft}}});
    joint.evidence.push_back(stack.reason);
    if (joint.thread->isPitchStated) joint.evidence.emplace_back(kModelledHelix);
    joint.makesHole =
        std::any_of(stack.hosts.begin(), stack.hosts.end(), [](const AroundShaft& host) { return host.hasNoHole(); });
    if (joint.makesHole)
      joint.evidence.emplace_back(GLISSADE_TEXT("the file has no hole there, so the screw makes it"));
    addDoubt(stack.doubt, stack.isDeepened, joint);
    for (const AroundShaft& host : stack.hosts) {
      if (isNutOn(host.body, axis, shape.shaft)) nutsTaken_.insert(host.body);
    }
    for (const AroundShaft& around : stack.clamped) clampedOn_.emplace(around.body, body);
    if (stack.hosts.size() == 1 && isNutOn(joint.others[0], axis, shape.shaft) &&
        isLoose(joint.others[0], body, axis)) {
      turnNut(joint, axis);
    }
    joints.push_back(std::move(joint));
  }

  bool isLoose(std::size_t nut, std::size_t shaft, const AxisLine& axis) const {
    std::vector<const RigidBody*> others;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (i != nut && i != shaft) others.push_back(&shapes_.body(i));
    }
    const double radius = shapes_.turned(nut)->hole;
    return isLooseNut(shapes_.body(nut), {axis.point, axis.direction, radius, radius, true}, others, stop_);
  }

  /// Makes the nut, and not the screw, the body that turns.
  void turnNut(Joint& joint, const AxisLine& axis) const {
    const std::size_t nut = joint.others[0];
    const TurnedShape& shape = *shapes_.turned(nut);
    joint.kind = JointKind::Nut;
    joint.others = {joint.body};
    joint.body = nut;
    joint.direction = -axis.direction;
    joint.point = shapes_.axisOf(nut).point;
    joint.drive = shape.drive.kind;
    joint.driveSize = shape.drive.size;
    joint.evidence.emplace_back(GLISSADE_TEXT("the nut is free to be turned"));
  }

  /// A body that a screw clamps counts as a nut on it only if its name says so.
  void addNutOnRod(std::size_t nut, const TurnedShape& shape, Joints& joints) {
    const AxisLine axis = shapes_.axisOf(nut);
    const bool isNamed = says(said_, nut, {StandardPart::Nut});
    for (const std::size_t rod : shapes_.near(axis, {shape.low, shape.high, shape.hole}, nut)) {
      if (!isNamed && clampedOn_.count({nut, rod}) != 0) continue;
      const auto [radius, on] = rodIn(rod, shape, axis);
      if (on < kOnShaft * shape.length()) continue;
      const NutOnShaft found = nutOnShaft(shapes_, said_, {nut, rod, radius, isScrew(rod)});
      if (!found.isThread) continue;
      joints.push_back(nutOnRod({nut, rod, radius}, shape, axis, on));
      joints.back().evidence.push_back(found.evidence);
      addDoubt(found.doubt, found.isDeepened, joints.back());
      return;
    }
  }

  /// Radius of a shaft in the hole of a nut, and the length of the nut that it is in; 0 if there is none.
  std::pair<double, double> rodIn(std::size_t rod, const TurnedShape& shape, const AxisLine& axis) const {
    double on = 0.0;
    double thickest = 0.0;
    const AxisLine seen = shapes_.seenFrom(rod, axis);
    for (const AxialSlab& slab : shapes_.axial(rod).slabsAbout(seen, {shape.low, shape.high, 1.5 * shape.hole})) {
      const double radius = slab.nearestAt(0.9);
      if (!slab.isSolid || radius < kThinnestRod * shape.hole || radius > kThickestRod * shape.hole) continue;
      on += slab.length();
      thickest = std::max(thickest, radius);
    }
    return {thickest, on};
  }

  /// A thread is called by the wider of shaft and hole: one of them may be drawn as its core.
  Joint nutOnRod(const NutAndShaft& pair, const TurnedShape& shape, const AxisLine& axis, double on) const {
    const auto [nut, rod, shaft, isScrew] = pair;
    const double radius = std::max(shaft, shape.hole);
    double low = shape.low;
    double high = shape.high;
    for (const Vector3& vertex : shapes_.body(rod).mesh->vertices) {
      const double height = axis.heightOf(shapes_.body(rod).X_WB * vertex);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    const bool isUp = high - shape.low <= shape.high - low;
    Joint joint;
    joint.kind = JointKind::Nut;
    joint.body = nut;
    joint.others = {rod};
    joint.point = axis.point;
    joint.direction = isUp ? axis.direction : Vector3(-axis.direction);
    JointThread thread;
    thread.diameter = 2.0 * radius;
    thread.pitch = pitchOfDepth(radius, radius - shape.hole);
    thread.engaged = on;
    thread.travel = isUp ? high - shape.low : shape.high - low;
    joint.thread = thread;
    joint.drive = shape.drive.kind;
    joint.driveSize = shape.drive.size;
    joint.evidence.push_back({GLISSADE_TEXT("a nut with a hole of %1"), {Length{2.0 * shape.hole}}});
    return joint;
  }

  const ProductShapes& shapes_;
  const Designations& said_;
  const StopToken& stop_;
  std::set<std::size_t> nutsTaken_;
  std::set<std::pair<std::size_t, std::size_t>> clampedOn_;  ///< a clamped body, and the screw that clamps it
};

}  // namespace

Joints findThreadedJoints(const ProductShapes& shapes, const Designations& said, const StopToken& stop) {
  return ThreadedJointFinder(shapes, said, stop).find();
}

}  // namespace glissade
