#include "engine/collision/forbidding_query.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/screw_axis.h"

namespace glissade {
namespace {

/// Angle of a screw motion that is tested as one chord, radians.
constexpr double kChordAngle = 0.02;
/// Most chords of a screw motion. A longer one counts as forbidden here, after which its edges are tested one by one.
constexpr double kMostChords = 1e6;
/// Largest distance of the reported first forbidden configuration behind the beginning of the forbidden part, as a
/// share of the object's radius.
constexpr double kBeyond = 1e-3;

}  // namespace

ForbiddingQuery::ForbiddingQuery(std::unique_ptr<CollisionQuery> bodies, std::shared_ptr<const ForbiddenSpace> space)
    : bodies_(std::move(bodies)), space_(std::move(space)) {}

const ForbiddenRegions* ForbiddingQuery::regions() {
  const std::uint64_t now = space_->revision();
  if (now != seen_) {
    regions_ = space_->regions();
    seen_ = now;
  }
  return regions_.get();
}

bool ForbiddingQuery::isForbidden(const Pose& X_WB) {
  if (space_->motions() != nullptr && !space_->motions()->mayBeAt(X_WB)) return true;
  const ForbiddenRegions* now = regions();
  return now != nullptr && now->holding(X_WB.position);
}

bool ForbiddingQuery::collides(const Pose& X_WB) { return isForbidden(X_WB) || bodies_->collides(X_WB); }

std::optional<int> ForbiddingQuery::collidingBody(const Pose& X_WB) {
  const auto body = bodies_->collidingBody(X_WB);
  return !body && isForbidden(X_WB) ? std::make_optional(kForbiddenPlace) : body;
}

NearestObstacle ForbiddingQuery::nearestObstacle(const Pose& X_WB) {
  if (!isForbidden(X_WB)) return bodies_->nearestObstacle(X_WB);
  NearestObstacle forbidden;
  forbidden.body = kForbiddenPlace;
  return forbidden;
}

double ForbiddingQuery::distanceUpTo(const Pose& X_WB, double enough) {
  return isForbidden(X_WB) ? 0.0 : bodies_->distanceUpTo(X_WB, enough);
}

bool ForbiddingQuery::clearAbove(const Pose& X_WB, double bound) {
  return !isForbidden(X_WB) && bodies_->clearAbove(X_WB, bound);
}

MotionCheck ForbiddingQuery::checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                         const StopToken& stop) {
  if (!mayMove(from, to)) return {CertificateStatus::Violated, 0.0, 0.0, 1};
  const auto stretch = forbiddenOn(from, to);
  if (!stretch) return bodies_->checkMotion(from, to, required, seek, stop);
  const double beyond = kBeyond * motionBound().objectRadius() / (to.position - from.position).norm();
  const double at = stretch->begin + std::min(0.5 * (stretch->end - stretch->begin), beyond);
  if (seek == SeekViolation::Any) return {CertificateStatus::Violated, 0.0, at, 1};
  MotionCheck check = bodies_->checkMotion(from, to, required, seek, stop);
  if (check.status == CertificateStatus::Violated && check.at <= at) return check;
  check.status = check.certified < stretch->begin ? CertificateStatus::Undecided : CertificateStatus::Violated;
  check.certified = std::min(check.certified, stretch->begin);
  check.at = at;
  return check;
}

double ForbiddingQuery::screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough,
                                       double off) {
  return mayTouch(from, screw, advance, off) ? 0.0 : bodies_->screwClearance(from, screw, advance, enough, off);
}

std::optional<ForbiddenStretch> ForbiddingQuery::forbiddenOn(const Pose& from, const Pose& to) {
  const ForbiddenRegions* now = regions();
  return now == nullptr ? std::nullopt : now->firstOn(from.position, to.position);
}

bool ForbiddingQuery::mayMove(const Pose& from, const Pose& to) {
  return space_->motions() == nullptr || space_->motions()->mayMove(from, to);
}

double ForbiddingQuery::forbiddenMargin() {
  const ForbiddenRegions* now = regions();
  return now == nullptr ? 0.0 : now->margin();
}

/// True if the screw motion may touch a forbidden place. The reference point moves on a helix, which is near its
/// chords.
bool ForbiddingQuery::mayTouch(const Pose& from, const ScrewAxis& screw, double advance, double off) {
  const ForbiddenRegions* now = regions();
  if (now == nullptr && space_->motions() == nullptr) return false;
  const double arm = (from.position - screw.point_W).cross(screw.axis_W).norm();
  const double chords = std::ceil(std::abs(screw.turnFor(advance)) / kChordAngle);
  if (chords > kMostChords) return true;
  const double apart = off + arm * (1.0 - std::cos(0.5 * kChordAngle)) + 1e-9 * (arm + std::abs(advance));
  Pose begin = from;
  for (double chord = 1.0; chord <= std::max(1.0, chords); chord += 1.0) {
    const Pose end = screwed(screw, from, advance * chord / std::max(1.0, chords));
    if (!mayMove(begin, end)) return true;
    if (now != nullptr && now->mayBeWithin(apart, begin.position, end.position)) return true;
    begin = end;
  }
  return false;
}

}  // namespace glissade
