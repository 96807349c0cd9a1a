#include "engine/collision/kernel/placed_object.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// A length along an axis comes out of fewer than this many roundings, each at most half a unit in the
/// last place of the largest coordinate: those of the stored box and pose (2 + 4), of placing (6 and
/// 6 for the axis), of the two projections (2 * 5) and of the sum of the half extents (6).
constexpr double kRoundings = 40.0;
constexpr double kHalfUlp = std::numeric_limits<float>::epsilon() / 2.0;

}  // namespace

PlacedObject::PlacedObject(const BoxTree& obstacles, const BoxTree& object, const lanes::LaneFunctions& functions)
    : obstacles_(&obstacles),
      object_(object),
      functions_(functions),
      placedAt_(object.nodes.size(), 0),
      placed_(object.nodes.size()) {}

void PlacedObject::moveTo(const Pose& X_WB) {
  X_WB_ = X_WB;
  swept_ = false;
  const Eigen::Matrix3d rotation = X_WB.orientation.toRotationMatrix();
  const Vector3 translation = rotation * object_.centre + (X_WB.position - obstacles_->centre);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) X_.rotation[i][k] = static_cast<float>(rotation(i, k));
    X_.translation[i] = static_cast<float>(translation[i]);
  }
  const double distance = translation.norm();
  // A quaternion that is not quite of unit length stretches.
  const double stretch = 4.0 * std::abs(X_WB.orientation.squaredNorm() - 1.0) * object_.reach;
  slack_ = static_cast<float>(kRoundings * kHalfUlp * (distance + obstacles_->reach + object_.reach) + stretch);
  sphereGap_ = (distance - obstacles_->reach - object_.reach - stretch) * (1.0 - 1e-12);
  if (++current_ == 0) {
    std::fill(placedAt_.begin(), placedAt_.end(), 0);
    current_ = 1;
  }
}

void PlacedObject::sweep(const Velocity& velocity, double half) {
  swept_ = true;
  sweeps_.resize(placed_.size());
  const double angle = half * velocity.rotation;
  const Vector3 turn = angle * (X_WB_.orientation * velocity.axis_B);
  const Vector3 pivot = X_WB_.position - obstacles_->centre;
  const Vector3 way = half * velocity.translation_W;
  const Eigen::Matrix3d across{{0.0, -turn.z(), turn.y()}, {turn.z(), 0.0, -turn.x()}, {-turn.y(), turn.x(), 0.0}};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) sweep_.turn[i][k] = static_cast<float>(across(i, k));
    sweep_.pivot[i] = static_cast<float>(pivot[i]);
    sweep_.way[i] = static_cast<float>(way[i]);
  }
  sweep_.angle = static_cast<float>(angle);
  const double coordinates = pivot.norm() + 2.0 * (object_.centre.norm() + object_.reach);
  sweepSlack_ = static_cast<float>(kRoundings * kHalfUlp * (angle * coordinates + way.norm()));
}

void PlacedObject::place(std::uint32_t index) {
  placedAt_[index] = current_;
  functions_.placeBoxes(object_.nodes[index], X_, placed_[index]);
  if (!swept_) return;
  const float* radius = object_.radius.data() + std::size_t{index} * lanes::kWidth;
  functions_.sweepBoxes(placed_[index], radius, sweep_, sweeps_[index]);
}

void PlacedObject::sweepTriangles(const lanes::TriangleLanes& placed, lanes::TriangleLanes& ways) const {
  functions_.sweepTriangles(placed, sweep_, ways);
}

void PlacedObject::leaf(BoxTree::Box box, lanes::TriangleLanes& placed) const {
  functions_.placeTriangles(object_.leafOf(box).lanes, X_, placed);
}

Triangle PlacedObject::triangle(std::uint32_t index) const {
  const Triangle& corners = object_.triangles[index].corners;
  return {X_WB_ * corners[0], X_WB_ * corners[1], X_WB_ * corners[2]};
}

}  // namespace glissade
