#include "engine/collision/kernel/occurrence_query.h"

#include <algorithm>
#include <cmath>

#include "engine/collision/motion_union.h"

namespace glissade {
namespace {

/// Relative widening of boxes, larger than the rounding of a placed corner.
constexpr double kBoxRounding = 1e-14;
/// A motion is halved if the cosine of half its angle is smaller. Near half a turn the sense of rotation is decided by
/// rounding, which differs between frames.
constexpr double kNearlyHalfATurn = 1e-6;

Box3 widenedBox(const Box3& box) {
  if (box.isEmpty()) return box;
  const double coordinates = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const Vector3 margin = Vector3::Constant(kBoxRounding * coordinates);
  return {box.min() - margin, box.max() + margin};
}

std::vector<Box3> widenedBoxes(const std::vector<Box3>& boxes) {
  std::vector<Box3> widened;
  widened.reserve(boxes.size());
  for (const Box3& box : boxes) widened.push_back(widenedBox(box));
  return widened;
}

double reachOf(const Box3& box) {
  return box.isEmpty() ? 0.0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

std::shared_ptr<const KernelGeometry> ofOneOccurrence(const OccurrenceGeometry& geometry) {
  const auto first = geometry.occurrences.empty()
                         ? std::make_shared<const BoxTree>(std::vector<OwnedTriangle>(), std::size_t{1})
                         : geometry.occurrences.front().tree;
  return std::make_shared<const KernelGeometry>(geometry.scale, first, geometry.object);
}

}  // namespace

OccurrenceGeometry::OccurrenceGeometry(double commonScale, std::vector<Occurrence> placed,
                                       const std::vector<Box3>& boxesOfPlaced, std::shared_ptr<const BoxTree> moving,
                                       const Box3& boxOfMoving)
    : scale(commonScale), occurrences(std::move(placed)), boxes(widenedBoxes(boxesOfPlaced)) {
  setObject(std::move(moving), boxOfMoving);
}

void OccurrenceGeometry::setObject(std::shared_ptr<const BoxTree> tree, const Box3& box) {
  object = std::move(tree);
  objectBox = box;
  objectReach = reachOf(box);
}

OccurrenceQuery::OccurrenceQuery(std::shared_ptr<const OccurrenceGeometry> geometry)
    : geometry_(std::move(geometry)), one_(ofOneOccurrence(*geometry_)) {}

/// A box around the object at this pose.
Box3 OccurrenceQuery::boxAt(const Pose& X_WB) const {
  const Box3& box = geometry_->objectBox;
  if (box.isEmpty()) return box;
  const Vector3 centre = X_WB * Vector3(box.center());
  const Vector3 half = X_WB.orientation.toRotationMatrix().cwiseAbs() * (0.5 * box.sizes());
  return widenedBox({centre - half, centre + half});
}

/// A box around the object on the whole motion. The reference point stays in the box of its ends.
Box3 OccurrenceQuery::boxOfMotion(const Pose& from, const Pose& to) const {
  if (from.orientation.coeffs() == to.orientation.coeffs()) return boxAt(from).merged(boxAt(to));
  const Vector3 reach = Vector3::Constant(geometry_->objectReach);
  return widenedBox({from.position.cwiseMin(to.position) - reach, from.position.cwiseMax(to.position) + reach});
}

KernelQuery& OccurrenceQuery::ask(std::uint32_t occurrence) {
  one_.setObstacles(*geometry_->occurrences[occurrence].tree);
  return one_;
}

/// The object's pose in the frame of the mesh. Positions are subtracted first, so that no precision is lost far from
/// the origin.
Pose OccurrenceQuery::seenFrom(std::uint32_t occurrence, const Pose& X_WB) const {
  const Pose& X_WM = geometry_->occurrences[occurrence].X_WM;
  const Quaternion turn = X_WM.orientation.conjugate();
  return {turn * (X_WB.position - X_WM.position), (turn * X_WB.orientation).normalized()};
}

bool OccurrenceQuery::touches(const Pose& X_WB) {
  bool touching = false;
  geometry_->boxes.visit(boxAt(X_WB), 0.0, [&](std::uint32_t i) {
    touching = ask(i).touches(seenFrom(i, X_WB));
    return !touching;
  });
  return touching;
}

std::optional<int> OccurrenceQuery::touchingBody(const Pose& X_WB) {
  std::vector<std::uint32_t> near;
  geometry_->boxes.visit(boxAt(X_WB), 0.0, [&](std::uint32_t i) {
    near.push_back(i);
    return true;
  });
  std::sort(near.begin(), near.end());
  for (const std::uint32_t i : near) {
    if (ask(i).touches(seenFrom(i, X_WB))) return static_cast<int>(i);
  }
  return std::nullopt;
}

NearestObstacle OccurrenceQuery::nearest(const Pose& X_WB, double enough) {
  NearestObstacle best;
  best.distance = enough;
  geometry_->boxes.visitNearestFirst(boxAt(X_WB), enough, [&](std::uint32_t i) {
    NearestObstacle found = ask(i).nearest(seenFrom(i, X_WB), best.distance);
    if (found.body < 0) return best.distance;
    found.body = static_cast<int>(i);
    const bool nearer = found.distance < best.distance || best.body < 0;
    if (!nearer && !(found.distance == best.distance && found.body < best.body)) return best.distance;
    const Pose& X_WM = geometry_->occurrences[i].X_WM;
    found.p_WPo = X_WM * found.p_WPo;
    found.p_WPn = X_WM * found.p_WPn;
    best = found;
    return best.distance;
  });
  return best;
}

bool OccurrenceQuery::isWithin(const Pose& X_WB, double bound) {
  if (bound < 0.0) return false;
  bool within = false;
  geometry_->boxes.visit(boxAt(X_WB), bound, [&](std::uint32_t i) {
    within = ask(i).isWithin(seenFrom(i, X_WB), bound);
    return !within;
  });
  return within;
}

std::optional<MotionCheck> OccurrenceQuery::checkMotion(const Pose& from, const Pose& to, double required,
                                                        SeekViolation seek, const StopToken& stop) {
  if (std::abs(from.orientation.dot(to.orientation)) > kNearlyHalfATurn) {
    return checkUnambiguous(from, to, required, seek, stop);
  }
  const Pose middle = interpolate(from, to, 0.5);
  MotionCheck check = checkUnambiguous(from, middle, required, seek, stop);
  check.certified *= 0.5;
  check.at *= 0.5;
  if (check.status != CertificateStatus::Certified) return check;
  MotionCheck second = checkUnambiguous(middle, to, required, seek, stop);
  second.configurations += check.configurations;
  second.certified = 0.5 + 0.5 * second.certified;
  second.at = 0.5 + 0.5 * second.at;
  return second;
}

MotionCheck OccurrenceQuery::checkUnambiguous(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                              const StopToken& stop) {
  MotionCheck united = certifiedMotion();
  geometry_->boxes.visit(boxOfMotion(from, to), required, [&](std::uint32_t i) {
    unite(united, *ask(i).checkMotion(seenFrom(i, from), seenFrom(i, to), required, seek, stop));
    return united.status != CertificateStatus::Violated || seek == SeekViolation::First;
  });
  return united;
}

}  // namespace glissade
