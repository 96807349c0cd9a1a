#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/collision_query.h"

namespace glissade {

/// Requirement of an edge of a path.
struct EdgeDemand {
  double clearance = 0.0;  ///< required clearance, metres, > 0
  bool sliding = false;    ///< it touches a contact configuration, so that the contact gap is required instead
};

/// Clearances of paths are proved up to this share of the object's radius about its frame. Larger clearances do not
/// matter, and so many pairs of triangles are within such distances that a proof takes minutes.
inline constexpr double kMostProvedShare = 1.0;

/// One edge of a path: its smallest clearance lies in [provedClearance, minClearance].
struct EdgeCertificate {
  CertificateStatus status = CertificateStatus::Undecided;
  EdgeDemand demand;
  double provedClearance = 0.0;  ///< proved lower bound, metres; >= the demand if certified
  double minClearance = 0.0;     ///< smallest distance met, metres
  double at = 0.0;               ///< place on the edge, in [0, 1]
  NearestObstacle nearest;       ///< nearest points there, of the object and this body
};

/// A continuous proof about a motion or a path, never sampled checks.
struct MotionCertificate {
  CertificateStatus status = CertificateStatus::Undecided;
  double tolerance = 0.0;        ///< required clearance, metres
  double minClearance = 0.0;     ///< smallest distance met at the configurations visited, metres
  double certified = 0.0;        ///< for one motion: the requirement is proved on [0, certified]
  double provedClearance = 0.0;  ///< lower bound on the clearance over the whole motion; >= tolerance if certified
  std::size_t edge = 0;          ///< edge of the path on which the smallest distance was met (0 for one motion)
  double at = 0.0;               ///< place on that edge, in [0, 1]; place of the violation if Violated
  NearestObstacle nearest;       ///< nearest points at that configuration
  bool againstThread = false;    ///< violated by a pair that is a thread, because the motion is no screw motion in it
  /// Distance that the reference point keeps from forbidden places, metres; 0: there are none.
  double forbiddenMargin = 0.0;
  std::uint64_t distanceQueries = 0;
  std::vector<EdgeCertificate> edges;  ///< edges of a path up to the first that is not certified; empty for one motion

  std::size_t slidingEdges() const;
};

/// Certifies the straight motion `interpolate(from, to, .)` by conservative advancement, steps of
/// (distance - requirement) / (largest speed of any point of the object). Precondition: requiredClearance > 0.
MotionCertificate certifyMotion(CollisionQuery& query, const Pose& from, const Pose& to, double requiredClearance,
                                const StopToken& stop = {});

/// An edge of a path that does not keep its demand, and the violation.
struct RefusedEdge {
  std::size_t edge;
  MotionCheck check;
};

/// The first refused edge; nothing where every edge keeps its demand. Without the distances of a certificate.
std::optional<RefusedEdge> firstRefusedEdge(CollisionQuery& query, const std::vector<Pose>& path,
                                            const std::vector<EdgeDemand>& demands, const StopToken& stop = {});

/// Certifies every edge of a path; stops at the first that is not certified and reports it. In a certified path the
/// clearance of every edge is proved down to half of the smallest distance met on it, and that of the whole path down
/// to nine tenths. It may be less after a stop, and for screw motions of more than a turn, which are proved as one
/// (CollisionQuery::screwClearance). A path of one configuration is certified if that configuration is clear.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path, double requiredClearance,
                              const StopToken& stop = {});

/// certifyPath() with its own demand for each edge (one for a path of one configuration). The certificate's tolerance
/// is the largest of them.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path,
                              const std::vector<EdgeDemand>& demands, const StopToken& stop = {});

/// Adds the certificate of the next edge to that of its path.
void addEdge(MotionCertificate& path, const MotionCertificate& edge, const EdgeDemand& demand);

/// Share of the straight motion on which the object stays free of collision, as sampling at `step` (in the metric of
/// the object's radius) would find it: the planner's growth check. Returns the last free sample before the first that
/// is not; 1 if all are free. Samples that are proved free together are not evaluated one by one. `from` must be free.
/// A sampled answer, not a proof. After a stop it returns the share so far.
double freeFraction(CollisionQuery& query, const Pose& from, const Pose& to, double step, const StopToken& stop = {});

}  // namespace glissade
