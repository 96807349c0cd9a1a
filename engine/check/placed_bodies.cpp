#include "engine/check/placed_bodies.h"

#include <cmath>

namespace glissade::check {
namespace {

double rounded(double number) {
  constexpr double kStep = 0x1p-34;
  return std::round(number / kStep) * kStep + 0.0;  // no -0
}

/// Of all poses that are the same but for rounding, one: what is measured does not depend on which came first.
Pose rounded(const Pose& pose) {
  const auto& q = pose.orientation;
  const Quaternion same = q.w() < 0.0 ? Quaternion(-q.coeffs()) : q;
  Eigen::Vector4d coefficients = same.coeffs();
  for (double& each : coefficients) each = rounded(each);
  const Vector3& p = pose.position;
  return {{rounded(p.x()), rounded(p.y()), rounded(p.z())}, Quaternion(coefficients).normalized()};
}

/// The first of two stays in its own frame, and the second is placed relative to it: that is done for each pair.
bool isFirst(const Body& one, const Body& other) {
  const std::size_t triangles = one.mesh->triangles.size();
  const std::size_t others = other.mesh->triangles.size();
  return triangles != others ? triangles > others : one.id < other.id;
}

Box3 grown(const Box3& box, double reach) {
  return Box3(box.min() - Vector3::Constant(reach), box.max() + Vector3::Constant(reach));
}

Box3 placed(const Box3& box, const Pose& X) {
  Box3 around;
  for (const auto corner : {Box3::BottomLeftFloor, Box3::BottomRightFloor, Box3::TopLeftFloor, Box3::TopRightFloor,
                            Box3::BottomLeftCeil, Box3::BottomRightCeil, Box3::TopLeftCeil, Box3::TopRightCeil}) {
    around.extend(X * box.corner(corner));
  }
  return around;
}

AllowanceBound noBound(const Body& body) {
  AllowanceBound none;
  none.atMost.assign(body.mesh->triangles.size(), 0.0);
  return none;
}

}  // namespace

const PlacedBody& PlacedBodies::at(const Placement& placement) {
  const TriangleMesh* mesh = placement.body.mesh.get();
  const std::lock_guard lock(mutex_);
  for (const Entry& entry : entries_) {
    if (entry.mesh == mesh && entry.X_WB == placement.X_WB) return *entry.placed;
  }
  entries_.push_back({mesh, placement.X_WB, std::make_unique<const PlacedBody>(placement.body, placement.X_WB)});
  return *entries_.back().placed;
}

PlacedBodies::MeasuredPtr PlacedBodies::measured(const PlacedBody& one, const PlacedBody& other,
                                                 const StopToken& stop) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = pairs_.find({&one, &other});
    if (known != pairs_.end()) return known->second;
  }
  auto found = std::make_shared<const MeasuredPair>(measurePair(one, other, stop));
  if (stop.stopRequested()) return found;
  const std::lock_guard lock(mutex_);
  return pairs_.try_emplace({&one, &other}, std::move(found)).first->second;
}

PairBounds PlacedBodies::boundsOf(const Placement& one, const Placement& other, const FitWords& fits,
                                  const PairWord* word, const StopToken& stop) {
  const bool inOrder = isFirst(one.body, other.body);
  const Placement& first = inOrder ? one : other;
  const Placement& second = inOrder ? other : one;
  const Pose relative = rounded(inverse(first.X_WB) * second.X_WB);
  const PlacedBody& a = at({first.body, Pose::identity()});
  const PlacedBody& own = at({second.body, Pose::identity()});
  if (!grown(a.tree.box(), touchingReach(a, own)).intersects(placed(own.tree.box(), relative))) {
    return {noBound(one.body), noBound(other.body)};
  }
  const PlacedBody& b = at({second.body, relative});
  const MeasuredPtr pair = measured(a, b, stop);
  const MeasuredBody ofFirst{a, pair->one};
  const MeasuredBody ofSecond{b, pair->other};
  return inOrder ? check::boundsOf(ofFirst, ofSecond, fits, word) : check::boundsOf(ofSecond, ofFirst, fits, word);
}

}  // namespace glissade::check
