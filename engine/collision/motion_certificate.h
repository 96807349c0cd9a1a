#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/collision_query.h"

namespace glissade {

/// A continuous proof about a motion (DESIGN section 4): conservative advancement by
/// (distance - requirement) / (largest speed of any point of the object), never sampled checks.
struct MotionCertificate {
  CertificateStatus status = CertificateStatus::Undecided;
  double tolerance = 0.0;        ///< the clearance that was required, metres
  double minClearance = 0.0;     ///< smallest distance met at the configurations visited, metres
  double certified = 0.0;        ///< one motion: the requirement is proved on [0, certified]
  double provedClearance = 0.0;  ///< lower bound on the clearance over the whole motion; >= tolerance if certified
  std::size_t edge = 0;          ///< edge of the path on which the smallest distance was met (0 for one motion)
  double at = 0.0;               ///< where on that edge, in [0, 1]; where the violation is if Violated
  NearestObstacle nearest;       ///< the pair at that place
  std::uint64_t distanceQueries = 0;
};

/// Certifies the straight motion `interpolate(from, to, .)`. Preconditions: requiredClearance > 0.
MotionCertificate certifyMotion(CollisionQuery& query, const Pose& from, const Pose& to, double requiredClearance,
                                const StopToken& stop = {});

/// Certifies every edge of a path; stops at the first that is not certified and reports it.
/// A path of one configuration is certified if that configuration is clear.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path, double requiredClearance,
                              const StopToken& stop = {});

/// How far along the straight motion the object stays free of collision, as sampling at `step` (in the
/// metric of the object's radius) would find it: the planner's growth check. Samples that are proved
/// free together are not taken one by one. Returns the last free sample before the first that is not;
/// 1 if all are free. `from` must be free. A sampled answer, not a proof. Stops early (returning the
/// progress so far) on request.
double freeFraction(CollisionQuery& query, const Pose& from, const Pose& to, double step, const StopToken& stop = {});

}  // namespace glissade
