#include "engine/collision/threaded_query.h"

#include <cmath>

namespace glissade {
namespace {

/// Halvings of a motion that is shown not to engage a thread, and how often it is looked at.
constexpr int kMostLooks = 4000;
/// A motion that leaves the screw is followed back to this power of a half.
constexpr int kSmallestStep = 24;

}  // namespace

ThreadedQuery::ThreadedQuery(std::unique_ptr<CollisionQuery> screwed, std::shared_ptr<const ThreadedWorld> threads)
    : screwed_(std::move(screwed)), whole_(threads->whole->makeQuery()), threads_(std::move(threads)) {}

ThreadedQuery::Taken ThreadedQuery::takenAt(const Pose& X_WB) {
  bool engaged = false;
  for (const ThreadPair& pair : threads_->pairs) {
    if (!pair.engaged(X_WB)) continue;
    if (!pair.isOnScrew(X_WB)) return {nullptr, pair.rule().obstacle};
    engaged = true;
  }
  return {engaged ? screwed_.get() : whole_.get(), -1};
}

bool ThreadedQuery::collides(const Pose& X_WB) {
  ++counts_.collision;
  const Taken taken = takenAt(X_WB);
  return taken.query == nullptr || taken.query->collides(X_WB);
}

std::optional<int> ThreadedQuery::collidingBody(const Pose& X_WB) {
  ++counts_.collision;
  const Taken taken = takenAt(X_WB);
  return taken.query == nullptr ? taken.forbidding : taken.query->collidingBody(X_WB);
}

NearestObstacle ThreadedQuery::nearestObstacle(const Pose& X_WB) {
  ++counts_.distance;
  const Taken taken = takenAt(X_WB);
  if (taken.query != nullptr) return taken.query->nearestObstacle(X_WB);
  NearestObstacle forbidden;
  forbidden.body = taken.forbidding;
  return forbidden;
}

double ThreadedQuery::distanceUpTo(const Pose& X_WB, double enough) {
  ++counts_.distance;
  const Taken taken = takenAt(X_WB);
  return taken.query == nullptr ? 0.0 : taken.query->distanceUpTo(X_WB, enough);
}

bool ThreadedQuery::clearAbove(const Pose& X_WB, double bound) {
  ++counts_.distance;
  const Taken taken = takenAt(X_WB);
  return taken.query != nullptr && taken.query->clearAbove(X_WB, bound);
}

MotionCheck ThreadedQuery::checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                       const StopToken& stop) {
  ++counts_.motion;
  bool engaged = false;
  for (const ThreadPair& pair : threads_->pairs) {
    if (neverEngaged(pair, from, to)) continue;
    engaged = true;
    if (pair.isScrewMotion(from, to)) continue;
    return {CertificateStatus::Violated, 0.0, firstForbidden(from, to), 1};
  }
  return (engaged ? screwed_ : whole_)->checkMotion(from, to, required, seek, stop);
}

/// From the middle of a part of the motion, no point of the object moves farther than half of its way.
bool ThreadedQuery::neverEngaged(const ThreadPair& pair, const Pose& from, const Pose& to) const {
  const double way = screwed_->motionBound()(from, to);
  struct Part {
    double begin;
    double end;
  };
  std::vector<Part> open{{0.0, 1.0}};
  for (int looks = 0; !open.empty(); ++looks) {
    const Part part = open.back();
    open.pop_back();
    const double middle = 0.5 * (part.begin + part.end);
    const Pose at = interpolate(from, to, middle);
    if (!pair.engagedWithin(at, 0.5 * way * (part.end - part.begin))) continue;
    if (looks == kMostLooks || way == 0.0 || pair.engaged(at)) return false;
    open.push_back({middle, part.end});
    open.push_back({part.begin, middle});
  }
  return true;
}

/// Where on a motion that leaves the screw an engaged configuration off it is.
double ThreadedQuery::firstForbidden(const Pose& from, const Pose& to) {
  for (int power = kSmallestStep; power > 0; --power) {
    const double t = std::ldexp(1.0, -power);
    if (takenAt(interpolate(from, to, t)).query == nullptr) return t;
  }
  return 1.0;
}

/// Its threads have a rule of their own, which other screw motions do not keep.
double ThreadedQuery::screwClearance(const Pose&, const ScrewAxis&, double, double) { return 0.0; }

}  // namespace glissade
