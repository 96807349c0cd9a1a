#include "engine/sequence/exploded_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Gap between the boxes of two bodies, as a share of the product's diagonal.
constexpr double kGapShare = 0.025;
/// Sampling of a motion: a sample for each third of the radius, but at least kFewestSamples.
constexpr double kSampleRadii = 0.33;
constexpr double kFewestSamples = 32.0;
constexpr double kMostSamples = 400.0;
/// Boxes are merged if the merged box has at most this factor more volume; a turn has hundreds of boxes.
constexpr double kMoreRoom = 1.15;

Box3 widened(const Box3& box, double by) {
  return {box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by)};
}

Box3 moved(const Box3& box, const Pose& by) {
  Box3 all;
  for (int corner = 0; corner < 8; ++corner) all.extend(by * box.corner(static_cast<Box3::CornerType>(corner)));
  return all;
}

/// The interval along the direction in which the moving box meets the other box; empty (first > second) if it never
/// does.
std::pair<double, double> meeting(const Box3& moving, const Vector3& direction, const Box3& other) {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = other.min()[axis] - moving.max()[axis];
    const double high = other.max()[axis] - moving.min()[axis];
    const double speed = direction[axis];
    if (std::abs(speed) < 1e-9) {
      if (low > 0.0 || high < 0.0) return {1.0, 0.0};
      continue;
    }
    from = std::max(from, std::min(low / speed, high / speed));
    to = std::min(to, std::max(low / speed, high / speed));
  }
  return {from, to};
}

/// The smallest distance from which on the box is clear of all others.
double clearDistance(const Box3& moving, const Vector3& direction, const std::vector<Box3>& others) {
  double distance = 0.0;
  for (bool met = true; met;) {
    met = false;
    for (const Box3& other : others) {
      const auto [from, to] = meeting(moving, direction, other);
      if (from > distance || to <= distance) continue;
      distance = to;
      met = true;
    }
  }
  return distance;
}

/// The direction in which a body continues after its path: the direction of the path, if an axis plane between the body
/// and the standing bodies then stays between them; else away from such a plane.
Vector3 directionBeyond(const Box3& body, const Box3& standing, const Vector3& direction) {
  Vector3 away = direction;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const bool between =
          side > 0.0 ? body.min()[axis] >= standing.max()[axis] : body.max()[axis] <= standing.min()[axis];
      if (!between) continue;
      if (side * direction[axis] >= 0.0) return direction;
      away = side * Vector3::Unit(axis);
    }
  }
  return away;
}

}  // namespace

/// Finds where each step stops, beginning with the last step.
class ExplodedView::Placement {
 public:
  Placement(const AssembledProduct& product, const std::vector<Step>& steps) {
    std::vector<bool> leaves(product.bodies.size(), false);
    for (const Step& step : steps) {
      for (const std::size_t body : step.bodies) leaves[body] = true;
    }
    Box3 whole;
    for (std::size_t body = 0; body < product.bodies.size(); ++body) {
      boxes_.push_back(boundingBox(*product.bodies[body].mesh, product.bodies[body].X_WB));
      whole.extend(boxes_.back());
      if (!leaves[body]) stand(boxes_.back());
    }
    gap_ = kGapShare * whole.diagonal().norm();
  }

  void place(Step& step, const Vector3& exit) {
    const double samples = samplesOf(step);
    const double length = step.way.length();
    double sample = 0.0;
    while (sample <= samples && !isClear(step, step.way.movedAt(length * sample / samples))) ++sample;
    step.along = length * std::min(1.0, sample / samples);
    if (sample > samples) goBeyond(step, exit);
    takeRoom(step, std::min(samples, std::max(1.0, sample)));
  }

 private:
  static double samplesOf(const Step& step) {
    return std::clamp(std::ceil(step.way.length() / (kSampleRadii * step.way.radius())), kFewestSamples, kMostSamples);
  }

  void stand(const Box3& box) {
    taken_.push_back(box);
    standing_.extend(box);
  }

  Box3 boxOf(const Step& step, const Pose& by) const {
    Box3 all;
    for (const std::size_t body : step.bodies) all.extend(moved(boxes_[body], by));
    return all;
  }

  bool isClear(const Step& step, const Pose& by) const {
    const Box3 box = widened(boxOf(step, by), gap_);
    return std::none_of(taken_.begin(), taken_.end(), [&box](const Box3& other) { return other.intersects(box); });
  }

  void goBeyond(Step& step, const Vector3& exit) const {
    const Box3 box = boxOf(step, step.way.movedAt(step.along));
    const Vector3 direction = directionBeyond(box, standing_, exit);
    step.beyond = clearDistance(widened(box, gap_), direction, taken_) * direction;
  }

  /// Adds the volume that the bodies cross on their motion; steps before this one stay out of it.
  void takeRoom(const Step& step, double samples) {
    for (const std::size_t body : step.bodies) {
      const Box3& box = boxes_[body];
      stand(box);
      Box3 before = box;
      for (double sample = 1.0; sample <= samples; ++sample) {
        const Box3 after = moved(box, step.way.movedAt(step.along * sample / samples));
        takePiece(before.merged(after));
        before = after;
      }
      takePiece(before.merged(before.translated(step.beyond)));
    }
  }

  /// Merges the piece with the last box if that adds little volume, so that a straight motion along an axis becomes one
  /// box.
  void takePiece(const Box3& piece) {
    const Box3 both = taken_.back().merged(piece);
    const double room = taken_.back().volume() + piece.volume() - taken_.back().intersection(piece).volume();
    if (both.volume() <= kMoreRoom * room) {
      taken_.back() = both;
    } else {
      taken_.push_back(piece);
    }
  }

  std::vector<Box3> boxes_;  ///< boxes of the assembled bodies
  std::vector<Box3> taken_;  ///< boxes taken by bodies that stay and by those that move later
  Box3 standing_;            ///< box of all bodies that stay or move later, assembled
  double gap_ = 0.0;
};

Pose ExplodedView::Step::movedAt(double way) const {
  if (way <= along) return this->way.movedAt(way);
  return Pose::translation((way - along) * beyond.normalized()) * this->way.movedAt(along);
}

ExplodedView::ExplodedView(const AssembledProduct& product, const AssemblyPlan& plan) : bodies_(product.bodies.size()) {
  std::vector<Vector3> exits;
  for (const AssemblyStep& step : plan.steps) {
    for (const StepMotion& motion : step.motions) {
      std::vector<std::size_t> bodies = product.indicesOf(motion.bodies());
      const StepWay way(motion, product.bodies[bodies.front()]);
      steps_.push_back({std::move(bodies), way});
      exits.push_back(exitDirection(motion.path));
    }
  }
  Placement placement(product, steps_);
  for (std::size_t i = steps_.size(); i-- > 0;) placement.place(steps_[i], exits[i]);
}

std::vector<Pose> ExplodedView::at(double share) const {
  std::vector<Pose> poses(bodies_, Pose::identity());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double done = std::clamp(share * static_cast<double>(steps_.size()) - static_cast<double>(i), 0.0, 1.0);
    for (const std::size_t body : steps_[i].bodies) poses[body] = steps_[i].movedAt(done * steps_[i].length());
  }
  return poses;
}

}  // namespace glissade
