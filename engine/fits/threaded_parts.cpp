#include "engine/fits/threaded_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "engine/evidence/crests.h"
#include "engine/fits/contact_report.h"
#include "engine/fits/shaft_helix.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// Largest distance of coaxial axes, in radii of the shaft.
constexpr double kOneAxisShare = 0.02;
/// Least engaged length of a thread: in radii of the shaft, or a pitch if that is less, as for wide caps.
constexpr double kLeastThreadLength = 0.15;
/// Share of the directions in which both bodies have to fill the volume between hole and shaft.
constexpr double kLeastFilled = 0.5;
/// Relative excess over the shaft, or deficit of the hole, that still passes.
constexpr double kPasses = 0.01;
/// Radius about the axis that is searched for obstructions, in radii of the shaft.
constexpr double kLookedAbout = 3.0;

/// A range along an axis of the world.
struct Span {
  double low = 0.0;
  double high = 0.0;

  double length() const { return high - low; }
};

Span spanOf(const CylinderRegion& cylinder, const AxisLine& axis) {
  const double first = axis.heightOf(cylinder.point + cylinder.low * cylinder.direction);
  const double last = axis.heightOf(cylinder.point + cylinder.high * cylinder.direction);
  return {std::min(first, last), std::max(first, last)};
}

/// A shaft of one body in a narrower hole of another body. Heights along the axis of the shaft.
struct DrawnThread {
  std::size_t shaftBody = 0;
  std::size_t holeBody = 0;
  AxisLine axis;
  double shaft = 0.0;  ///< radius, metres
  double hole = 0.0;
  Span ofShaft;
  Span ofHole;
  double pitch = 0.0;  ///< metres a turn, of a modelled helix; 0: none is

  Span engaged() const { return {std::max(ofShaft.low, ofHole.low), std::min(ofShaft.high, ofHole.high)}; }
  double depth() const { return shaft - hole; }
  /// Metres a turn: that of the helix, else that of the depth.
  double turned() const { return pitch != 0.0 ? pitch : pitchOfDepth(shaft, depth()); }
};

/// Makes the joint of a thread: the body that turns, and its exit direction.
class ThreadJointMaker {
 public:
  explicit ThreadJointMaker(const ProductShapes& shapes) : shapes_(shapes) {}

  Joint jointOf(const DrawnThread& thread) const {
    const auto shaftFlats = wrenchFlatsOf(thread.shaftBody);
    const auto holeFlats = wrenchFlatsOf(thread.holeBody);
    const bool shaftIsSmaller = volumeOf(thread.shaftBody) <= volumeOf(thread.holeBody);
    const bool turnsShaft = shaftFlats.has_value() != holeFlats.has_value() ? shaftFlats.has_value() : shaftIsSmaller;
    const bool isUp = leavesUp(thread);
    Joint joint;
    joint.kind = JointKind::Thread;
    joint.body = turnsShaft ? thread.shaftBody : thread.holeBody;
    joint.others = {turnsShaft ? thread.holeBody : thread.shaftBody};
    joint.point = thread.axis.point;
    joint.direction = isUp == turnsShaft ? thread.axis.direction : Vector3(-thread.axis.direction);
    JointThread& turned = joint.thread.emplace();
    turned.diameter = 2.0 * thread.shaft;
    turned.isPitchStated = thread.pitch != 0.0;
    turned.pitch = thread.turned();
    turned.engaged = thread.engaged().length();
    turned.travel = isUp ? thread.ofHole.high - thread.ofShaft.low : thread.ofShaft.high - thread.ofHole.low;
    if (const auto flats = turnsShaft ? shaftFlats : holeFlats) {
      joint.drive = DriveKind::HexOutside;
      joint.driveSize = *flats;
    }
    joint.evidence.push_back({GLISSADE_TEXT("a shaft of %1 is %2 thicker than the hole around it, as a thread is"),
                              {Length{2.0 * thread.shaft}, Length{2.0 * thread.depth()}}});
    joint.evidence.emplace_back(GLISSADE_TEXT("neither body is a screw or a nut by its shape"));
    if (turned.isPitchStated) joint.evidence.emplace_back(kModelledHelix);
    return joint;
  }

 private:
  std::optional<double> wrenchFlatsOf(std::size_t body) const {
    const TurnedShape* shape = shapes_.turned(body);
    return shape == nullptr ? std::nullopt : wrenchFlats(*shape);
  }

  double volumeOf(std::size_t body) const { return shapes_.box(body).volume(); }

  /// True if the shaft leaves in the direction of the axis; false if something blocks it there, or if it is free sooner
  /// in the opposite direction.
  bool leavesUp(const DrawnThread& thread) const {
    const Span shaft = extentOf(thread.shaftBody, thread.axis);
    const Span hole = extentOf(thread.holeBody, thread.axis);
    const bool up = passes(thread, {shaft.low, thread.ofShaft.low}, {thread.ofHole.high, hole.high});
    const bool down = passes(thread, {thread.ofShaft.high, shaft.high}, {hole.low, thread.ofHole.low});
    if (up != down) return up;
    return thread.ofHole.high - thread.ofShaft.low <= thread.ofShaft.high - thread.ofHole.low;
  }

  /// True if no part behind the shaft is wider than the shaft, and no part before the hole is narrower than the hole.
  bool passes(const DrawnThread& thread, const Span& behind, const Span& before) const {
    for (const AxialSlab& slab : slabsOf(thread.shaftBody, thread, behind)) {
      if (slab.outerMost() > (1.0 + kPasses) * thread.shaft) return false;
    }
    for (const AxialSlab& slab : slabsOf(thread.holeBody, thread, before)) {
      if (slab.isSolid || slab.nearestAt(0.0) < (1.0 - kPasses) * thread.hole) return false;
    }
    return true;
  }

  std::vector<AxialSlab> slabsOf(std::size_t body, const DrawnThread& thread, const Span& span) const {
    if (!(span.length() > kPasses * thread.shaft)) return {};
    const AxisLine seen = shapes_.seenFrom(body, thread.axis);
    return shapes_.axial(body).slabsAbout(seen, {span.low, span.high, kLookedAbout * thread.shaft});
  }

  Span extentOf(std::size_t body, const AxisLine& axis) const {
    const AxisLine seen = shapes_.seenFrom(body, axis);
    const std::vector<Vector3>& vertices = shapes_.body(body).mesh->vertices;
    Span span{seen.heightOf(vertices.front()), seen.heightOf(vertices.front())};
    for (const Vector3& vertex : vertices) {
      span.low = std::min(span.low, seen.heightOf(vertex));
      span.high = std::max(span.high, seen.heightOf(vertex));
    }
    return span;
  }

  const ProductShapes& shapes_;
};

class ThreadedPartFinder {
 public:
  ThreadedPartFinder(const ProductShapes& shapes, const Joints& known, const StopToken& stop)
      : shapes_(shapes), stop_(stop), cylinders_(shapes.size()) {
    for (const Joint& joint : known) {
      if (joint.kind == JointKind::Insert && joint.state == JointState::Suggested) continue;
      std::vector<std::size_t> bodies{joint.body};
      bodies.insert(bodies.end(), joint.others.begin(), joint.others.end());
      for (const std::size_t one : bodies) {
        for (const std::size_t other : bodies) joined_.emplace(one, other);
      }
    }
  }

  Joints find() {
    Joints joints;
    for (std::size_t a = 0; a < shapes_.size(); ++a) {
      for (std::size_t b = a + 1; b < shapes_.size() && !stop_.stopRequested(); ++b) {
        if (!shapes_.box(a).intersects(shapes_.box(b)) || joined_.count({a, b}) != 0) continue;
        std::optional<DrawnThread> best;
        takeLonger(a, b, best);
        takeLonger(b, a, best);
        if (!best) best = modelledThread(a, b);
        if (!best) best = modelledThread(b, a);
        if (best) joints.push_back(ThreadJointMaker(shapes_).jointOf(*best));
      }
    }
    std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.body < b.body; });
    return joints;
  }

 private:
  /// The cylinders of a body in the world, found once.
  const std::vector<CylinderRegion>& cylindersOf(std::size_t body) {
    if (!cylinders_[body]) cylinders_[body] = shapes_.cylindersOf(body);
    return *cylinders_[body];
  }

  void takeLonger(std::size_t shaftBody, std::size_t holeBody, std::optional<DrawnThread>& best) {
    const std::vector<CylinderRegion>& holes = cylindersOf(holeBody);
    for (const CylinderRegion& shaft : cylindersOf(shaftBody)) {
      if (!shaft.shaft) continue;
      for (const CylinderRegion& hole : holes) {
        if (hole.shaft) continue;
        const auto thread = threadOf(shaftBody, shaft, holeBody, hole);
        if (thread && (!best || thread->engaged().length() > best->engaged().length())) best = thread;
      }
    }
  }

  std::optional<DrawnThread> threadOf(std::size_t shaftBody, const CylinderRegion& shaft, std::size_t holeBody,
                                      const CylinderRegion& hole) const {
    const double depth = shaft.radius - hole.radius;
    const ContactLimits limits;
    const bool isLarge = depth > limits.clashOverlap || depth > limits.clashThickness * 2.0 * shaft.radius;
    const bool isClash = isLarge && !evidence::isCoreOfThread(shaft.radius, depth);
    if (isClash || !evidence::hasDepthOfThread(shaft.radius, depth)) return std::nullopt;
    const AxisLine axis{shaft.point, shaft.direction};
    if (!isSameAxis(axis, {hole.point, hole.direction}, kOneAxisShare * shaft.radius)) return std::nullopt;
    DrawnThread thread{shaftBody, holeBody, axis, shaft.radius, hole.radius, spanOf(shaft, axis), spanOf(hole, axis)};
    if (!isEngaged(thread) || !isFilledBy(shaftBody, thread) || !isFilledBy(holeBody, thread)) return std::nullopt;
    return thread;
  }

  /// Crests of a helix of the one that go into a round wall of the other one. Rings may be barbs.
  std::optional<DrawnThread> modelledThread(std::size_t crested, std::size_t other) {
    Box3 near = shapes_.box(crested);
    TriangleMesh inWorld;
    for (const CylinderRegion& wall : cylindersOf(other)) {
      if (stop_.stopRequested()) break;
      const Vector3 low = wall.point + wall.low * wall.direction;
      const Vector3 high = wall.point + wall.high * wall.direction;
      if (!near.intersects(Box3(low.cwiseMin(high), low.cwiseMax(high)))) continue;
      if (inWorld.vertices.empty()) {
        inWorld = transformed(*shapes_.body(crested).mesh, shapes_.body(crested).X_WB);
      }
      const evidence::RoundFace face{wall.point, wall.direction, wall.radius, wall.shaft, wall.low, wall.high};
      const auto crests = evidence::crestsInto(face, inWorld, stop_);
      if (!crests || crests->lead == 0.0) continue;
      const Span ofCrests{crests->low, crests->high};
      const Span ofWall{wall.low, wall.high};
      DrawnThread thread{wall.shaft ? other : crested,          wall.shaft ? crested : other,
                         {crests->point, wall.direction},       std::max(wall.radius, crests->radius),
                         std::min(wall.radius, crests->radius), wall.shaft ? ofWall : ofCrests,
                         wall.shaft ? ofCrests : ofWall,        crests->lead};
      if (isEngaged(thread)) return thread;
    }
    return std::nullopt;
  }

  static bool isEngaged(const DrawnThread& thread) {
    return thread.engaged().length() >= std::min(kLeastThreadLength * thread.shaft, std::abs(thread.turned()));
  }

  /// Between hole and shaft. A tube in a tube that is inside out is no thread.
  bool isFilledBy(std::size_t body, const DrawnThread& thread) const {
    const double middle = 0.5 * (thread.engaged().low + thread.engaged().high);
    const AxisLine seen = shapes_.seenFrom(body, thread.axis);
    return shapes_.axial(body).filledShare(seen, middle, 0.5 * (thread.shaft + thread.hole)) >= kLeastFilled;
  }

  const ProductShapes& shapes_;
  const StopToken& stop_;
  std::vector<std::optional<std::vector<CylinderRegion>>> cylinders_;  ///< one entry for each body; set on demand
  std::set<std::pair<std::size_t, std::size_t>> joined_;
};

}  // namespace

Joints findThreadedParts(const ProductShapes& shapes, const Joints& known, const StopToken& stop) {
  return ThreadedPartFinder(shapes, known, stop).find();
}

Joint jointOfThread(const ProductShapes& shapes, const std::pair<std::size_t, std::size_t>& pair,
                    const std::vector<evidence::CommonThread>& threads) {
  std::optional<DrawnThread> longest;
  for (const evidence::CommonThread& each : threads) {
    const Span own{each.low, each.high};
    const Span others{each.lowOther, each.highOther};
    const DrawnThread drawn{each.movingIsShaft ? pair.first : pair.second,
                            each.movingIsShaft ? pair.second : pair.first,
                            {each.point, each.axis},
                            each.radius,
                            each.radius - each.depth,
                            each.movingIsShaft ? own : others,
                            each.movingIsShaft ? others : own,
                            each.pitch};
    if (!longest || drawn.engaged().length() > longest->engaged().length()) longest = drawn;
  }
  return ThreadJointMaker(shapes).jointOf(*longest);
}

}  // namespace glissade
