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
/// Close bounds: proved down to this share of the smallest distance met.
constexpr double kCloseShare = 0.5;
/// More queries than this on one motion and it is given up as undecided: ten times what a slide of
/// ten metres at a gap of a millimetre takes.
constexpr std::uint64_t kMostQueries = 200'000;

/// Proves a motion ball by ball. A configuration with clearance c proves the motion free as long as
/// no point of the object has moved by more than c - required: an interval on both sides of it.
class Certifier {
 public:
  Certifier(CollisionQuery& query, const Pose& from, const Pose& to, double bound, double required, double share)
      : query_(query), from_(from), to_(to), bound_(bound), share_(share) {
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
      const double target = std::max(result_.tolerance, share_ * result_.minClearance);
      const double reach = bound_ > 0.0 ? (clearance - target) / bound_ : 1.0;
      if (probe - reach > proved) {
        probe = proved;  // the leap was too bold: fill the gap first
        continue;
      }
      const double end = std::min(1.0, probe + reach);
      // By construction at least the target; the maximum only takes rounding away.
      const double lowest = clearance - bound_ * std::max(probe - proved, end - probe);
      result_.provedClearance = std::min(result_.provedClearance, std::max(target, lowest));
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
  double share_;
  MotionCertificate result_;
};

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

std::size_t MotionCertificate::slidingEdges() const {
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const EdgeCertificate& edge) { return edge.demand.sliding; }));
}

MotionCertificate certifyMotion(CollisionQuery& query, const Pose& from, const Pose& to, double requiredClearance,
                                const StopToken& stop, ClearanceBounds bounds) {
  const double share = bounds == ClearanceBounds::Close ? kCloseShare : 0.0;
  return Certifier(query, from, to, query.motionBound()(from, to), requiredClearance, share).run(stop);
}

MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path, double requiredClearance,
                              const StopToken& stop) {
  const std::size_t edges = path.size() > 1 ? path.size() - 1 : path.size();
  return certifyPath(query, path, std::vector<EdgeDemand>(edges, {requiredClearance, false}), stop);
}

MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path,
                              const std::vector<EdgeDemand>& demands, const StopToken& stop, ClearanceBounds bounds) {
  MotionCertificate result;
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const Pose& to = path.size() > 1 ? path[i + 1] : path[i];
    addEdge(result, certifyMotion(query, path[i], to, demands[i].clearance, stop, bounds), demands[i]);
    if (result.status != CertificateStatus::Certified) break;
  }
  return result;
}

void addEdge(MotionCertificate& path, const MotionCertificate& edge, const EdgeDemand& demand) {
  const bool first = path.edges.empty();
  if (first || edge.minClearance < path.minClearance || edge.status != CertificateStatus::Certified) {
    path.minClearance = edge.minClearance;
    path.edge = path.edges.size();
    path.at = edge.at;
    path.nearest = edge.nearest;
  }
  path.provedClearance = first ? edge.provedClearance : std::min(path.provedClearance, edge.provedClearance);
  path.tolerance = std::max(path.tolerance, demand.clearance);
  path.distanceQueries += edge.distanceQueries;
  path.certified = edge.certified;
  path.status = edge.status;
  path.edges.push_back({edge.status, demand, edge.provedClearance, edge.minClearance, edge.at, edge.nearest});
}

double freeFraction(CollisionQuery& query, const Pose& from, const Pose& to, double step, const StopToken& stop) {
  const double length = Se3Metric(query.motionBound().objectRadius()).distance(from, to);
  if (length <= 0.0) return 1.0;
  return FreeSamples(query, from, to, step / length, stop).fraction();
}

}  // namespace glissade
