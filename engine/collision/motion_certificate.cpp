#include "engine/collision/motion_certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/se3_metric.h"

namespace glissade {
namespace {

/// A clearance within this share of the requirement counts as below it: the steps would shrink
/// towards nothing.
constexpr double kSlimmestMargin = 1e-3;
/// More queries than this on one motion and it is given up as undecided: ten times what a slide of
/// ten metres at a gap of a millimetre takes.
constexpr std::uint64_t kMostQueries = 200'000;

/// Proves a motion ball by ball. A configuration with clearance c proves the motion free as long as
/// no point of the object has moved by more than c - required: an interval on both sides of it.
class Certifier {
 public:
  Certifier(CollisionQuery& query, const Pose& from, const Pose& to, double bound, double required)
      : query_(query), from_(from), to_(to), bound_(bound) {
    result_.tolerance = required;
    result_.minClearance = std::numeric_limits<double>::infinity();
    result_.provedClearance = std::numeric_limits<double>::infinity();
  }

  MotionCertificate run(const StopToken& stop) {
    double proved = 0.0;  // the motion is free on [0, proved]
    double probe = 0.0;
    for (bool first = true; first || proved < 1.0; first = false) {
      if (stop.stopRequested() || result_.distanceQueries >= kMostQueries) return result_;
      const double clearance = clearanceAt(probe);
      const double margin = clearance - result_.tolerance;
      if (margin < kSlimmestMargin * result_.tolerance) {
        result_.status = CertificateStatus::Violated;
        return result_;
      }
      const double reach = bound_ > 0.0 ? margin / bound_ : 1.0;
      if (probe - reach > proved) {
        probe = proved;  // the leap was too bold: fill the gap first
        continue;
      }
      const double end = std::min(1.0, probe + reach);
      // By construction at least the requirement; the maximum only takes rounding away.
      const double lowest = clearance - bound_ * std::max(probe - proved, end - probe);
      result_.provedClearance = std::min(result_.provedClearance, std::max(result_.tolerance, lowest));
      result_.certified = proved = end;
      probe = std::min(1.0, proved + 0.9 * reach);
    }
    result_.status = CertificateStatus::Certified;
    return result_;
  }

 private:
  double clearanceAt(double t) {
    ++result_.distanceQueries;
    const NearestObstacle nearest = query_.nearestObstacle(interpolate(from_, to_, t));
    if (nearest.distance < result_.minClearance || result_.distanceQueries == 1) {
      result_.minClearance = nearest.distance;
      result_.at = t;
      result_.nearest = nearest;
    }
    return nearest.distance;
  }

  CollisionQuery& query_;
  const Pose& from_;
  const Pose& to_;
  double bound_;
  MotionCertificate result_;
};

/// Puts the certificate of one more edge into that of the path.
void accumulate(MotionCertificate& path, const MotionCertificate& edge, std::size_t index) {
  if (index == 0 || edge.minClearance < path.minClearance || edge.status != CertificateStatus::Certified) {
    path.minClearance = edge.minClearance;
    path.edge = index;
    path.at = edge.at;
    path.nearest = edge.nearest;
  }
  path.provedClearance = index == 0 ? edge.provedClearance : std::min(path.provedClearance, edge.provedClearance);
  path.distanceQueries += edge.distanceQueries;
  path.certified = edge.certified;
  path.status = edge.status;
}

/// The samples of a motion, 0 (known to be free) to `count`.
class FreeSamples {
 public:
  FreeSamples(CollisionQuery& query, const Pose& from, const Pose& to, double dt, const StopToken& stop)
      : query_(query), from_(from), to_(to), dt_(dt), bound_(query.motionBound()(from, to)), stop_(stop) {}

  double fraction() { return at(lastFree(0.0, std::ceil(1.0 / dt_))); }

 private:
  double at(double sample) const { return std::min(1.0, sample * dt_); }

  /// The last sample in [first, last] before one that collides; `first` is free. Halves the run until
  /// it is proved free as one, or is short.
  double lastFree(double first, double last) {
    constexpr double kShort = 2.0;
    if (stop_.stopRequested()) return first;
    if (last - first <= kShort) {
      for (double sample = first + 1.0; sample <= last; ++sample) {
        if (query_.collides(interpolate(from_, to_, at(sample)))) return sample - 1.0;
      }
      return last;
    }
    const double middle = std::floor(0.5 * (first + last));
    const double way = bound_ * std::max(at(middle) - at(first), at(last) - at(middle));
    if (query_.clearAbove(interpolate(from_, to_, at(middle)), way)) return last;
    const double reached = lastFree(first, middle);
    return reached < middle ? reached : lastFree(middle, last);
  }

  CollisionQuery& query_;
  const Pose& from_;
  const Pose& to_;
  double dt_;
  double bound_;
  const StopToken& stop_;
};

}  // namespace

MotionCertificate certifyMotion(CollisionQuery& query, const Pose& from, const Pose& to, double requiredClearance,
                                const StopToken& stop) {
  return Certifier(query, from, to, query.motionBound()(from, to), requiredClearance).run(stop);
}

MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path, double requiredClearance,
                              const StopToken& stop) {
  MotionCertificate result;
  result.tolerance = requiredClearance;
  const std::size_t edges = path.size() > 1 ? path.size() - 1 : path.size();
  for (std::size_t i = 0; i < edges; ++i) {
    const Pose& to = path.size() > 1 ? path[i + 1] : path[i];
    accumulate(result, certifyMotion(query, path[i], to, requiredClearance, stop), i);
    if (result.status != CertificateStatus::Certified) break;
  }
  return result;
}

double freeFraction(CollisionQuery& query, const Pose& from, const Pose& to, double step, const StopToken& stop) {
  const double length = Se3Metric(query.motionBound().objectRadius()).distance(from, to);
  if (length <= 0.0) return 1.0;
  return FreeSamples(query, from, to, step / length, stop).fraction();
}

}  // namespace glissade
