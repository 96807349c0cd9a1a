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
      proved = end;
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
  path.status = edge.status;
}

}  // namespace

double motionBound(const TriangleMesh& object, const Pose& from, const Pose& to) {
  const double translation = (to.position - from.position).norm();
  // The axis of the shortest turn is constant in the object's own frame.
  const Vector3 axis = (from.orientation.conjugate() * to.orientation).vec();
  if (axis.isZero(0.0)) return translation;
  const Vector3 direction = axis.normalized();
  double squaredArm = 0.0;
  for (const Vector3& vertex : object.vertices) {
    squaredArm = std::max(squaredArm, direction.cross(vertex).squaredNorm());
  }
  return translation + angleBetween(from.orientation, to.orientation) * std::sqrt(squaredArm);
}

MotionCertificate certifyMotion(CollisionQuery& query, const TriangleMesh& object, const Pose& from, const Pose& to,
                                double requiredClearance, const StopToken& stop) {
  return Certifier(query, from, to, motionBound(object, from, to), requiredClearance).run(stop);
}

MotionCertificate certifyPath(CollisionQuery& query, const TriangleMesh& object, const std::vector<Pose>& path,
                              double requiredClearance, const StopToken& stop) {
  MotionCertificate result;
  result.tolerance = requiredClearance;
  const std::size_t edges = path.size() > 1 ? path.size() - 1 : path.size();
  for (std::size_t i = 0; i < edges; ++i) {
    const Pose& to = path.size() > 1 ? path[i + 1] : path[i];
    accumulate(result, certifyMotion(query, object, path[i], to, requiredClearance, stop), i);
    if (result.status != CertificateStatus::Certified) break;
  }
  return result;
}

double freeFraction(CollisionQuery& query, const TriangleMesh& object, const Pose& from, const Pose& to, double step,
                    const StopToken& stop) {
  // A distance costs about as much as this many yes/no samples: leap where it is worth more.
  constexpr int kSamplesPerDistance = 8;
  const double length = Se3Metric(radiusAboutOrigin(object)).distance(from, to);
  if (length <= 0.0) return 1.0;
  const double dt = step / length;
  const double bound = motionBound(object, from, to);
  double free = 0.0;
  while (free < 1.0) {
    if (stop.stopRequested()) return free;
    const double leap = query.nearestObstacle(interpolate(from, to, free)).distance / bound;
    if (leap > kSamplesPerDistance * dt) {
      // Just short of the ball's rim: the end itself must be free, not in touch.
      free = std::min(1.0, free + 0.999 * leap);
      continue;
    }
    for (int i = 0; i < kSamplesPerDistance && free < 1.0; ++i) {
      const double next = std::min(1.0, free + dt);
      if (query.collides(interpolate(from, to, next))) return free;
      free = next;
    }
  }
  return 1.0;
}

}  // namespace glissade
