#include "engine/collision/threaded_query.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Halvings of a motion that is shown not to engage a thread, and how often it is looked at.
constexpr int kMostLooks = 4000;
/// A motion that leaves the screw is followed back to this power of a half.
constexpr int kSmallestStep = 24;

/// Shares of a screw motion's pitch, by which the proofs of the screwed and of the whole object overlap.
constexpr double kOverlap = 1e-6;

/// Whether the pair is never engaged during a motion on which no point of the object moves farther than `way`.
template <class PoseAt>
bool isNeverEngaged(const ThreadPair& pair, double way, const PoseAt& poseAt) {
  struct Part {
    double begin;
    double end;
  };
  std::vector<Part> open{{0.0, 1.0}};
  for (int looks = 0; !open.empty(); ++looks) {
    const Part part = open.back();
    open.pop_back();
    const double middle = 0.5 * (part.begin + part.end);
    const Pose at = poseAt(middle);
    if (!pair.engagedWithin(at, 0.5 * way * (part.end - part.begin))) continue;
    if (looks == kMostLooks || way == 0.0 || pair.engaged(at)) return false;
    open.push_back({middle, part.end});
    open.push_back({part.begin, middle});
  }
  return true;
}

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
  return isNeverEngaged(pair, way, [&](double t) { return interpolate(from, to, t); });
}

/// The first time of a motion away from the screw at which an engaged configuration is off the screw motion.
double ThreadedQuery::firstForbidden(const Pose& from, const Pose& to) {
  for (int power = kSmallestStep; power > 0; --power) {
    const double t = std::ldexp(1.0, -power);
    if (takenAt(interpolate(from, to, t)).query == nullptr) return t;
  }
  return 1.0;
}

/// How far along a screw motion that begins engaged some thread is; nothing where the motion is not that of all of
/// these, or may engage another one.
std::optional<double> ThreadedQuery::engagedAdvance(const Pose& from, const ScrewAxis& screw, double advance,
                                                    double off) const {
  double farthest = 0.0;
  for (const ThreadPair& pair : threads_->pairs) {
    if (pair.engaged(from)) {
      if (!pair.permitsScrew(from, screw, advance, off)) return std::nullopt;
      const double sense = screw.axis_W.dot(pair.rule().axis_W) * advance;
      farthest = std::max(farthest, std::abs(pair.advanceOut(from, sense)) + pair.margin());
      continue;
    }
    const double arm = (from.position - screw.point_W).cross(screw.axis_W).norm() + motionBound().objectRadius();
    const double way = std::hypot(advance, screw.turnFor(advance) * arm) + 2.0 * off;
    const auto poseAt = [&](double t) { return screwed(screw, from, t * advance); };
    if (!isNeverEngaged(pair, way, poseAt)) return std::nullopt;
  }
  return farthest;
}

/// A motion that ends engaged is looked at from its end. Beyond the threads the object is whole.
double ThreadedQuery::screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough,
                                     double off) {
  ++counts_.motion;
  const auto& pairs = threads_->pairs;
  const auto isEngaged = [&](const Pose& at) {
    return std::any_of(pairs.begin(), pairs.end(), [&](const ThreadPair& pair) { return pair.engaged(at); });
  };
  const bool backwards = !isEngaged(from);
  const Pose begin = backwards ? screwed(screw, from, advance) : from;
  const double along = backwards ? -advance : advance;
  if (backwards && !isEngaged(begin)) return 0.0;
  const auto engaged = engagedAdvance(begin, screw, along, off);
  if (!engaged) return 0.0;
  const double overlap = off + kOverlap * std::abs(screw.pitch);
  const double sense = along < 0.0 ? -1.0 : 1.0;
  const double screwedPart = sense * std::min(std::abs(along), *engaged + overlap);
  const double shown = screwed_->screwClearance(begin, screw, screwedPart, enough, off);
  const double wholeFrom = sense * std::max(0.0, *engaged - overlap);
  if (std::abs(wholeFrom) >= std::abs(along) || shown <= 0.0) return shown;
  return whole_->screwClearance(screwed(screw, begin, wholeFrom), screw, along - wholeFrom, shown, off);
}

QueryCounts ThreadedQuery::counts() const {
  QueryCounts counts = counts_;
  counts.pairs = screwed_->counts().pairs + whole_->counts().pairs;
  return counts;
}

}  // namespace glissade
