#include "engine/evidence/placed_bodies.h"

#include <cmath>

namespace glissade::evidence {
namespace {

double rounded(double number) {
  constexpr double kStep = 0x1p-34;
  return std::round(number / kStep) * kStep + 0.0;  // no -0
}

/// Maps poses that differ by rounding errors to one pose, so that no result depends on which of several congruent pairs
/// is measured first.
Pose rounded(const Pose& pose) {
  const auto& q = pose.orientation;
  const Quaternion same = q.w() < 0.0 ? Quaternion(-q.coeffs()) : q;
  Eigen::Vector4d coefficients = same.coeffs();
  for (double& each : coefficients) each = rounded(each);
  const Vector3& p = pose.position;
  return {{rounded(p.x()), rounded(p.y()), rounded(p.z())}, Quaternion(coefficients).normalized()};
}

/// The first body of a pair stays in its own frame and is prepared once; the second one is prepared for each relative
/// pose. The larger mesh is therefore the first.
bool isFirst(const Body& one, const Body& other) {
  const std::size_t triangles = one.mesh->triangles.size();
  const std::size_t others = other.mesh->triangles.size();
  return triangles != others ? triangles > others : one.id < other.id;
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
  std::vector<Entry>& entries = entries_[mesh];
  for (const Entry& entry : entries) {
    if (entry.X_WB == placement.X_WB) return *entry.placed;
  }
  entries.push_back({placement.X_WB, std::make_unique<const PlacedBody>(placement.body, placement.X_WB)});
  return *entries.back().placed;
}

void PlacedBodies::measure(const Placement& one, const Placement& other, const StopToken& stop) {
  (void)measured(ordered(one, other), stop);
}

PlacedBodies::MeasuredHere PlacedBodies::measured(const Ordered& pair, const StopToken& stop) {
  const PlacedBody& own = at({pair.secondBody, Pose::identity()});
  const Box3 box = own.tree.box().transformed(toIsometry(pair.second));
  if (pair.first.tree.box().exteriorDistance(box) > touchingReach(pair.first, own)) return {};
  const PlacedBody& second = at({pair.secondBody, pair.second});
  const auto make = [&] {
    MeasuredPair found = measurePair(pair.first, second, stop);
    if (found.other.patches) {
      found.other.mesh = std::make_shared<const TriangleMesh>(found.other.patches->divided(*pair.secondBody.mesh));
    }
    return std::make_shared<const MeasuredPair>(std::move(found));
  };
  return {&second, pairs_.get({&pair.first, &second}, stop, make)};
}

PairBounds PlacedBodies::boundsOf(const Placement& one, const Placement& other, const FitWords& fits,
                                  const PairWord* word, const StopToken& stop) {
  PairBounds bounds = boundsInContact(one, other, fits, word, stop);
  if (const SnapWord* snap = fits.snapOf(one.body.id, other.body.id)) {
    const bool hookIsOne = snap->hook == one.body.id;
    if (hookIsOne) {
      addHook(*snap, one, other, bounds.one, stop);
    } else {
      addHook(*snap, other, one, bounds.other, stop);
    }
  }
  return bounds;
}

/// Works in the frame of the body with the hook; the direction is stated where the product is assembled. Adds nothing
/// for a bend larger than any hook of the body permits.
void PlacedBodies::addHook(const SnapWord& snap, const Placement& hook, const Placement& edge, AllowanceBound& bound,
                           const StopToken& stop) {
  if (snap.bend > mostBendOf(*hook.body.mesh)) return;
  const PlacedBody& own = at({hook.body, Pose::identity()});
  const PlacedBody& other = at({edge.body, rounded(inverse(hook.X_WB) * edge.X_WB)});
  const Vector3 direction = hook.body.X_WB.orientation.conjugate() * snap.direction;
  const auto regions = measuredHook({own, other, direction, snap.bend}, stop);
  addBend(*regions, snap.bend, own, own.spacing + other.spacing, bound);
}

PlacedBodies::HookPtr PlacedBodies::measuredHook(const HookQuestion& question, const StopToken& stop) {
  const Vector3& d = question.direction;
  const HookKey key{&question.hook, &question.edge, d.x(), d.y(), d.z(), question.bend};
  return hooks_.get(key, stop, [&] { return std::make_shared<const std::vector<bool>>(hookRegions(question, stop)); });
}

MeshPtr PlacedBodies::hollowOf(const Placement& body, const Placement& guest, const StopToken& stop) {
  const PlacedBody& own = at({body.body, Pose::identity()});
  const PlacedBody& other = at({guest.body, rounded(inverse(body.X_WB) * guest.X_WB)});
  return hollows_.get({&own, &other}, stop, [&] {
    std::optional<TriangleMesh> made = hollowed(own, other, stop);
    return made ? std::make_shared<const TriangleMesh>(std::move(*made)) : nullptr;
  });
}

PlacedBodies::Ordered PlacedBodies::ordered(const Placement& one, const Placement& other) {
  const bool inOrder = isFirst(one.body, other.body);
  const Placement& first = inOrder ? one : other;
  const Placement& second = inOrder ? other : one;
  return {inOrder, at({first.body, Pose::identity()}), second.body, rounded(inverse(first.X_WB) * second.X_WB)};
}

Cut PlacedBodies::cutOf(const Placement& one, const Placement& other, const FitWords& fits, const StopToken& stop) {
  const Ordered pair = ordered(one, other);
  const PlacedBody& first = pair.first;
  const PlacedBody& second = at({pair.secondBody, pair.second});
  const CutShape shape = cuts_.get({&first, &second}, stop, [&] { return cutShapeOf(first, second, stop); });
  const bool namesOne = fits.isCut(one.body.id);
  const bool namesOther = fits.isCut(other.body.id);
  Cut cut =
      pair.isInOrder ? evidence::cutOf(shape, namesOne, namesOther) : evidence::cutOf(shape, namesOther, namesOne);
  if (cut == Cut::NotClear && fits.acceptedClash == kAdvisedClashes) {
    const bool takesFirst = first.halfDiagonal <= second.halfDiagonal ? shape.oneStaysWhole : !shape.otherStaysWhole;
    cut = takesFirst ? Cut::One : Cut::Other;
  }
  if (pair.isInOrder || (cut != Cut::One && cut != Cut::Other)) return cut;
  return cut == Cut::One ? Cut::Other : Cut::One;
}

PairBounds PlacedBodies::boundsInContact(const Placement& one, const Placement& other, const FitWords& fits,
                                         const PairWord* word, const StopToken& stop) {
  const Ordered pair = ordered(one, other);
  const MeasuredHere found = measured(pair, stop);
  if (!found.pair) return {noBound(one.body), noBound(other.body)};
  const MeasuredBody first{pair.first, found.pair->one};
  const MeasuredBody second{*found.second, found.pair->other};
  return pair.isInOrder ? evidence::boundsOf(first, second, fits, word) : evidence::boundsOf(second, first, fits, word);
}

}  // namespace glissade::evidence
