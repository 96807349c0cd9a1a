#include "engine/collision/motion_certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/collision/coordinate_rounding.h"
#include "engine/collision/screw_run.h"
#include "engine/geometry/se3_metric.h"

namespace glissade {
namespace {

/// Least margin as a share of the requirement. A smaller clearance counts as below the requirement, because the steps
/// would become too short.
constexpr double kSlimmestMargin = 1e-3;
/// Share of the smallest distance met down to which the clearance of an edge, and of the whole path, is proved.
constexpr double kEdgeShare = 0.5;
constexpr double kPathShare = 0.9;
/// Relative increase of the bound of a path's deviation from its screw motion above its rounding.
constexpr double kScrewRounding = 1e-9;
/// Most queries for one motion, after which it is undecided: ten times the number for a slide of ten metres at a gap of
/// a millimetre.
constexpr std::uint64_t kMostQueries = 200'000;
/// Most samples of one edge, which a double counts exactly. The limits of lengths keep the number below it.
constexpr double kMostSamples = 1e15;

void refuseForbidden(double at, MotionCertificate& result) {
  result.status = CertificateStatus::Violated;
  result.minClearance = result.provedClearance = 0.0;
  result.at = at;
  result.nearest = {};
  result.nearest.body = kForbiddenPlace;
}

/// Proves a motion ball by ball. A configuration with clearance c proves the motion free as long as
/// no point of the object has moved by more than c - required: an interval on both sides of it.
class Certifier {
 public:
  Certifier(CollisionQuery& query, const Pose& from, const Pose& to, double required)
      : query_(query), from_(from), to_(to), bound_(query.motionBound()(from, to)) {
    result_.tolerance = required;
    result_.minClearance = std::numeric_limits<double>::infinity();
    result_.provedClearance = std::numeric_limits<double>::infinity();
  }

  MotionCertificate run(const StopToken& stop) {
    if (!resolvesClearance(from_, to_, query_.motionBound().objectRadius(), result_.tolerance)) return result_;
    if (!query_.mayMove(from_, to_)) {
      refuseForbidden(0.0, result_);
      return result_;
    }
    if (const auto stretch = query_.forbiddenOn(from_, to_)) {
      refuseForbidden(stretch->begin, result_);
      return result_;
    }
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
        probe = proved;  // the step was too long: fill the gap first
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

/// The end of an edge. A path of one configuration is an edge that ends where it begins.
const Pose& endOfEdge(const std::vector<Pose>& path, std::size_t edge) {
  return path[std::min(edge + 1, path.size() - 1)];
}

/// Brackets the clearance of a path's edges by the distances at its configurations and, where an edge comes nearer than
/// half of them, at the nearest configurations found. The proofs are motion checks, which do not need the distances on
/// the motion.
class PathCertifier {
 public:
  PathCertifier(CollisionQuery& query, const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                const StopToken& stop)
      : query_(query), path_(path), demands_(demands), stop_(stop), screwed_(demands.size(), 0.0) {
    for (const ScrewRun& run : screwRunsOf(path, query.motionBound().objectRadius())) proveScrew(run);
  }

  MotionCertificate run() {
    const auto refused = refusedEdge();
    std::vector<MotionCertificate> edges = metAtEnds(refused ? refused->edge + 1 : demands_.size());
    if (refused) {
      refuse(*refused, edges.back());
    } else {
      for (std::size_t i = 0; i < edges.size(); ++i) raise(i, edges[i]);
      narrow(edges);
    }
    MotionCertificate result;
    result.forbiddenMargin = query_.forbiddenMargin();
    for (std::size_t i = 0; i < edges.size(); ++i) addEdge(result, edges[i], demands_[i]);
    return result;
  }

  std::optional<RefusedEdge> refusedEdge() {
    for (std::size_t i = 0; i < demands_.size(); ++i) {
      if (screwed_[i] > 0.0) continue;
      const MotionCheck found = check(i, demands_[i].clearance);
      if (found.status != CertificateStatus::Certified) return RefusedEdge{i, found};
    }
    return std::nullopt;
  }

 private:
  const Pose& endOf(std::size_t edge) const { return endOfEdge(path_, edge); }

  /// Proves a screw motion of many turns as one. Its edges are not proved again where the bound is large enough.
  void proveScrew(const ScrewRun& run) {
    const Pose& from = path_[run.first];
    const Pose& to = endOf(run.last);
    const double apart = query_.nearestObstacle(from).distance;
    const double off = run.off * (1.0 + kScrewRounding);
    if (apart <= off || stop_.stopRequested()) return;
    const double shown = query_.screwClearance(from, run.screw, run.advance, apart, off) - off;
    for (std::size_t edge = run.first; edge <= run.last; ++edge) {
      const double demanded = demands_[edge].clearance;
      if (shown >= demanded && resolvesClearance(from, to, query_.motionBound().objectRadius(), demanded)) {
        screwed_[edge] = shown;
      }
    }
  }

  MotionCheck check(std::size_t edge, double clearance) {
    return query_.checkMotion(path_[edge], endOf(edge), clearance, SeekViolation::Any, stop_);
  }

  /// Certificates of the first edges, with their demands proved and the distances at their ends.
  std::vector<MotionCertificate> metAtEnds(std::size_t count) {
    std::vector<MotionCertificate> edges;
    NearestObstacle atStart;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0) atStart = query_.nearestObstacle(path_[0]);
      const NearestObstacle atEnd = query_.nearestObstacle(endOf(i));
      const bool nearerAtEnd = atEnd.distance < atStart.distance;
      MotionCertificate edge;
      edge.status = CertificateStatus::Certified;
      edge.certified = 1.0;
      edge.tolerance = edge.provedClearance = demands_[i].clearance;
      edge.provedClearance = std::max(edge.provedClearance, screwed_[i]);
      edge.nearest = nearerAtEnd ? atEnd : atStart;
      edge.minClearance = edge.nearest.distance;
      edge.at = nearerAtEnd ? 1.0 : 0.0;
      edge.distanceQueries = i == 0 ? 2 : 1;
      edges.push_back(edge);
      atStart = atEnd;
    }
    return edges;
  }

  void meet(std::size_t edge, double at, MotionCertificate& result) {
    ++result.distanceQueries;
    const NearestObstacle nearest = query_.nearestObstacle(interpolate(path_[edge], endOf(edge), at));
    if (nearest.distance >= result.minClearance) return;
    result.minClearance = nearest.distance;
    result.at = at;
    result.nearest = nearest;
  }

  void refuse(const RefusedEdge& refused, MotionCertificate& result) {
    result.status = refused.check.status;
    result.certified = refused.check.certified;
    result.provedClearance = 0.0;
    if (result.status != CertificateStatus::Violated) return;
    const Pose& from = path_[refused.edge];
    const auto stretch = query_.forbiddenOn(from, endOf(refused.edge));
    const bool isForbidden =
        (stretch && refused.check.at >= stretch->begin) || !query_.mayMove(from, endOf(refused.edge));
    if (isForbidden) return refuseForbidden(refused.check.at, result);
    meet(refused.edge, refused.check.at, result);
  }

  /// Raises the proved clearance of an edge that keeps its demand to near the smallest distance met. Where the motion
  /// check finds a smaller distance, that is met next, so that every turn halves the rest.
  void raise(std::size_t edge, MotionCertificate& result) {
    if (screwed_[edge] > 0.0) return;
    for (double bound = worthProving(kEdgeShare * result.minClearance);
         bound > result.provedClearance && !stop_.stopRequested();
         bound = kEdgeShare * std::min(bound, result.minClearance)) {
      const MotionCheck found = check(edge, bound);
      if (found.status == CertificateStatus::Certified) result.provedClearance = bound;
      if (found.status == CertificateStatus::Violated) meet(edge, found.at, result);
    }
  }

  /// Brackets the clearance of the whole path, which is displayed, more closely than that of each edge. This concerns
  /// only the few edges that come nearest.
  void narrow(std::vector<MotionCertificate>& edges) {
    double least = std::numeric_limits<double>::infinity();
    for (const MotionCertificate& edge : edges) least = std::min(least, edge.minClearance);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      while (screwed_[i] <= 0.0 && worthProving(kPathShare * least) > edges[i].provedClearance &&
             !stop_.stopRequested()) {
        const double bound = worthProving(kPathShare * least);
        const MotionCheck found = check(i, bound);
        if (found.status == CertificateStatus::Certified) edges[i].provedClearance = bound;
        if (found.status == CertificateStatus::Violated) meet(i, found.at, edges[i]);
        if (edges[i].minClearance >= least) break;  // proved, or undecided
        least = edges[i].minClearance;
      }
    }
  }

  double worthProving(double clearance) const {
    return std::min(clearance, kMostProvedShare * query_.motionBound().objectRadius());
  }

  CollisionQuery& query_;
  const std::vector<Pose>& path_;
  const std::vector<EdgeDemand>& demands_;
  const StopToken& stop_;
  std::vector<double> screwed_;  ///< clearance of each edge that was proved as a part of a screw motion; 0: it was not
};

/// The samples of a motion, from 0 (known to be free) to `count`.
class FreeSamples {
 public:
  FreeSamples(CollisionQuery& query, const Pose& from, const Pose& to, double dt, const StopToken& stop)
      : query_(query), from_(from), to_(to), dt_(dt), bound_(query.motionBound()(from, to)), stop_(stop) {}

  /// The share of the motion before a collision or a forbidden place.
  double fraction() {
    const auto stretch = query_.forbiddenOn(from_, to_);
    const double last = std::ceil((stretch ? stretch->begin : 1.0) / dt_);
    return at(lastFree(0.0, stretch ? std::max(0.0, last - 1.0) : last));
  }

 private:
  double at(double sample) const { return std::min(1.0, sample * dt_); }

  /// The last sample in [first, last] before one that collides; `first` is free. The range is halved until it is proved
  /// free as a whole, or is short. A range of four samples is rarely proved, and halving down to two takes a tenth more
  /// queries.
  double lastFree(double first, double last) {
    constexpr double kShort = 4.0;
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
                                const StopToken& stop) {
  return Certifier(query, from, to, requiredClearance).run(stop);
}

MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path, double requiredClearance,
                              const StopToken& stop) {
  const std::size_t edges = path.size() > 1 ? path.size() - 1 : path.size();
  return certifyPath(query, path, std::vector<EdgeDemand>(edges, {requiredClearance, false}), stop);
}

std::optional<RefusedEdge> firstRefusedEdge(CollisionQuery& query, const std::vector<Pose>& path,
                                            const std::vector<EdgeDemand>& demands, const StopToken& stop) {
  return PathCertifier(query, path, demands, stop).refusedEdge();
}

MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path,
                              const std::vector<EdgeDemand>& demands, const StopToken& stop) {
  return PathCertifier(query, path, demands, stop).run();
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
  path.againstThread = edge.againstThread;
  path.status = edge.status;
  path.edges.push_back({edge.status, demand, edge.provedClearance, edge.minClearance, edge.at, edge.nearest});
}

double freeFraction(CollisionQuery& query, const Pose& from, const Pose& to, double step, const StopToken& stop) {
  const double length = Se3Metric(query.motionBound().objectRadius()).distance(from, to);
  if (length <= 0.0) return 1.0;
  if (!(length <= kMostSamples * step)) return 0.0;
  return FreeSamples(query, from, to, step / length, stop).fraction();
}

}  // namespace glissade
