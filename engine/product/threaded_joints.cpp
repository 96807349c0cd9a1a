#include "engine/product/threaded_joints.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/quantity_text.h"
#include "engine/product/loose_nut.h"
#include "engine/product/shaft_helix.h"
#include "engine/product/thread_pitch.h"

namespace glissade {
namespace {

/// Hole of a nut by the radius of the shaft in it.
constexpr double kLeastNutHole = 0.7;
constexpr double kMostNutHole = 1.12;
/// A hole that is drawn as wide as the thread outside, or wider than a core that is drawn.
constexpr double kMostFreeGap = 1.3;
constexpr double kClearerHole = 1.03;
/// Axes of a nut and its shaft are this near, by the radius.
constexpr double kSameAxisShare = 0.15;
/// Length in which a thread has to be engaged, by the shaft's radius.
constexpr double kLeastEngaged = 0.15;
/// A nut lies on its shaft in this share of its height.
constexpr double kOnShaft = 0.5;

/// What lies along the shaft of a screw, and which of it has the thread.
struct ScrewStack {
  std::vector<AroundShaft> hosts;    ///< the nearest to the head first
  std::vector<AroundShaft> clamped;  ///< likewise
  std::string reason;                ///< why the hosts are taken for hosts
};

class ThreadedJointFinder {
 public:
  ThreadedJointFinder(const ProductShapes& shapes, const std::vector<bool>& isScrewByName, const StopToken& stop)
      : shapes_(shapes), isScrewByName_(isScrewByName), stop_(stop) {}

  Joints find() {
    Joints joints;
    for (std::size_t body = 0; body < shapes_.size() && !stop_.stopRequested(); ++body) {
      const TurnedShape* shape = shapes_.turned(body);
      if (shape == nullptr) continue;
      if (shape->kind == TurnedKind::Screw || shape->kind == TurnedKind::SetScrew) addScrew(body, *shape, joints);
    }
    for (std::size_t body = 0; body < shapes_.size() && !stop_.stopRequested(); ++body) {
      const TurnedShape* shape = shapes_.turned(body);
      if (shape != nullptr && shape->kind == TurnedKind::Nut && nutsTaken_.count(body) == 0) {
        addNutOnRod(body, *shape, joints);
      }
    }
    return joints;
  }

 private:
  bool isNutOn(std::size_t body, const AxisLine& axis, double radius) const {
    const TurnedShape* shape = shapes_.turned(body);
    return shape != nullptr && shape->kind == TurnedKind::Nut && shape->hole >= kLeastNutHole * radius &&
           shape->hole <= kMostNutHole * radius && isSameAxis(shapes_.axisOf(body), axis, kSameAxisShare * radius);
  }

  /// Another screw in the same place is a variant of it.
  bool isTwin(std::size_t body, const AxisLine& axis, double radius) const {
    const TurnedShape* shape = shapes_.turned(body);
    return shape != nullptr && shape->kind == TurnedKind::Screw &&
           isSameAxis(shapes_.axisOf(body), axis, kSameAxisShare * radius);
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
    const AxisLine axis = shapes_.axisOf(body);
    ScrewStack stack;
    const double least = kLeastEngaged * shape.shaft;
    for (const AroundShaft& around : all) {
      if (around.tight >= least) stack.hosts.push_back(around);
    }
    if (!stack.hosts.empty()) stack.reason = "the shaft is thicker than the hole";
    if (stack.hosts.empty()) {
      for (const AroundShaft& around : all) {
        if (isNutOn(around.body, axis, shape.shaft)) stack.hosts.push_back(around);
      }
      if (!stack.hosts.empty()) stack.reason = "a nut is on the shaft";
    }
    const bool isScrew = shape.drive.kind != DriveKind::None || isScrewByName_[body];
    if (stack.hosts.empty() && isScrew) takeDeepestHole(all, shape, stack);
    if (!stack.hosts.empty()) takeClamped(all, shape, stack);
    return stack;
  }

  /// Holes that are drawn as wide as the shaft, or wider: the farthest one from the head.
  void takeDeepestHole(const std::vector<AroundShaft>& all, const TurnedShape& shape, ScrewStack& stack) const {
    if (all.empty()) return;
    const double least = kLeastEngaged * shape.shaft;
    for (auto around = all.rbegin(); around != all.rend(); ++around) {
      if (around->equal < least) continue;
      stack.hosts.push_back(*around);
      stack.reason = "the hole is as wide as the shaft, and the farthest from the head";
      return;
    }
    const AroundShaft& last = all.back();
    if (last.hole > kMostFreeGap * shape.shaft) return;
    // Washers and spacers are around the shaft, however wide.
    const auto isWiderOrRing = [&](const AroundShaft& other) {
      const TurnedShape* turned = shapes_.turned(other.body);
      const bool isRing = turned != nullptr && turned->kind == TurnedKind::Ring;
      return isRing || other.hole > kClearerHole * last.hole;
    };
    const bool isNarrowest = all.size() > 1 && std::all_of(all.begin(), all.end() - 1, isWiderOrRing);
    if (!isNarrowest && !last.isBlind) return;
    stack.hosts.push_back(last);
    stack.reason = "the hole is the narrowest, and the farthest from the head";
  }

  /// What the head, or a washer below it, does not let pass.
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
    thread.pitch = isoCoarsePitch(shape.shaft).pitch;
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
    joint.evidence.push_back("a shaft of " + inMillimetres(2.0 * shape.shaft) +
                             (shape.kind == TurnedKind::Screw ? " with a head" : " with a recess"));
    joint.evidence.push_back(stack.reason);
    for (const AroundShaft& host : stack.hosts) {
      if (isNutOn(host.body, axis, shape.shaft)) nutsTaken_.insert(host.body);
    }
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

  /// The nut is what is turned, not the screw.
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
    joint.evidence.emplace_back("the nut is free to be turned");
  }

  void addNutOnRod(std::size_t nut, const TurnedShape& shape, Joints& joints) {
    const AxisLine axis = shapes_.axisOf(nut);
    for (const std::size_t rod : shapes_.near(axis, {shape.low, shape.high, shape.hole}, nut)) {
      double on = 0.0;
      const AxisLine seen = shapes_.seenFrom(rod, axis);
      for (const AxialSlab& slab : shapes_.axial(rod).slabsAbout(seen, {shape.low, shape.high, 1.5 * shape.hole})) {
        const double radius = slab.nearestAt(0.9);
        const bool isShaft =
            slab.isSolid && radius * kLeastNutHole <= shape.hole && radius * kMostNutHole >= shape.hole;
        on += isShaft ? slab.length() : 0.0;
      }
      if (on < kOnShaft * shape.length()) continue;
      joints.push_back(nutOnRod(nut, rod, shape, axis, on));
      return;
    }
  }

  Joint nutOnRod(std::size_t nut, std::size_t rod, const TurnedShape& shape, const AxisLine& axis, double on) const {
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
    thread.diameter = 2.0 * shape.hole;
    thread.pitch = isoCoarsePitch(shape.hole).pitch;
    thread.engaged = on;
    thread.travel = isUp ? high - shape.low : shape.high - low;
    joint.thread = thread;
    joint.drive = shape.drive.kind;
    joint.driveSize = shape.drive.size;
    joint.evidence = {"a nut with a hole of " + inMillimetres(2.0 * shape.hole), "a shaft is in the hole"};
    return joint;
  }

  const ProductShapes& shapes_;
  const std::vector<bool>& isScrewByName_;
  const StopToken& stop_;
  std::set<std::size_t> nutsTaken_;
};

}  // namespace

Joints findThreadedJoints(const ProductShapes& shapes, const std::vector<bool>& isScrewByName, const StopToken& stop) {
  return ThreadedJointFinder(shapes, isScrewByName, stop).find();
}

}  // namespace glissade
