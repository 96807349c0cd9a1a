#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/collision_query.h"

namespace glissade {

/// What an edge of a path has to keep.
struct EdgeDemand {
  double clearance = 0.0;  ///< metres, > 0
  bool sliding = false;    ///< it touches a contact configuration, and is held to the contact gap instead
};

/// Clearances of paths are proved up to this share of the object's radius about its frame: whether it is half a metre
/// away or one decides nothing, and so many pairs of triangles are within that reach that a proof takes minutes.
inline constexpr double kMostProvedShare = 1.0;

/// One edge of a path: its smallest clearance lies in [provedClearance, minClearance].
struct EdgeCertificate {
  CertificateStatus status = CertificateStatus::Undecided;
  EdgeDemand demand;
  double provedClearance = 0.0;  ///< proved lower bound, metres; >= the demand if certified
  double minClearance = 0.0;     ///< smallest distance met, metres
  double at = 0.0;               ///< where on the edge that was, in [0, 1]
  NearestObstacle nearest;       ///< the pair there: the object and this body
};

/// A continuous proof about a motion or a path, never sampled checks.
struct MotionCertificate {
  CertificateStatus status = CertificateStatus::Undecided;
  double tolerance = 0.0;        ///< the clearance that was required, metres
  double minClearance = 0.0;     ///< smallest distance met at the configurations visited, metres
  double certified = 0.0;        ///< one motion: the requirement is proved on [0, certified]
  double provedClearance = 0.0;  ///< lower bound on the clearance over the whole motion; >= tolerance if certified
  std::size_t edge = 0;          ///< edge of the path on which the smallest distance was met (0 for one motion)
  double at = 0.0;               ///< where on that edge, in [0, 1]; where the violation is if Violated
  NearestObstacle nearest;       ///< the pair at that configuration
  bool againstThread = false;    ///< violated: the pair is a thread, and the motion is no turn in it
  double forbiddenMargin = 0.0;  ///< metres that the reference point keeps from forbidden places; 0: there are none
  std::uint64_t distanceQueries = 0;
  std::vector<EdgeCertificate> edges;  ///< of a path, up to the first that is not certified; empty for one motion

  std::size_t slidingEdges() const;
};

/// Certifies the straight motion `interpolate(from, to, .)` by conservative advancement, steps of
/// (distance - requirement) / (largest speed of any point of the object). Precondition: requiredClearance > 0.
MotionCertificate certifyMotion(CollisionQuery& query, const Pose& from, const Pose& to, double requiredClearance,
                                const StopToken& stop = {});

/// An edge of a path that does not keep its demand, and what was found on it.
struct RefusedEdge {
  std::size_t edge;
  MotionCheck check;
};

/// The first of them; nothing where every edge keeps its demand. Yes or no, without the distances that a
/// certificate holds.
std::optional<RefusedEdge> firstRefusedEdge(CollisionQuery& query, const std::vector<Pose>& path,
                                            const std::vector<EdgeDemand>& demands, const StopToken& stop = {});

/// Certifies every edge of a path; stops at the first that is not certified and reports it. Of a certified path
/// the clearance of every edge is proved down to half of the smallest distance met on it, that of the whole path
/// down to nine tenths; less after a stop, and of screw motions of more than a turn, which are proved as one
/// (CollisionQuery::screwClearance).
/// A path of one configuration is certified if that configuration is clear.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path, double requiredClearance,
                              const StopToken& stop = {});

/// The same with a demand of its own for each edge (one for a path of one configuration). The
/// certificate's tolerance is the largest of them.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<Pose>& path,
                              const std::vector<EdgeDemand>& demands, const StopToken& stop = {});

/// Takes the certificate of the next edge into that of its path.
void addEdge(MotionCertificate& path, const MotionCertificate& edge, const EdgeDemand& demand);

/// How far along the straight motion the object stays free of collision, as sampling at `step` (in the
/// metric of the object's radius) would find it: the planner's growth check. Samples that are proved
/// free together are not taken one by one. Returns the last free sample before the first that is not;
/// 1 if all are free. `from` must be free. A sampled answer, not a proof. Stops early (returning the
/// progress so far) on request.
double freeFraction(CollisionQuery& query, const Pose& from, const Pose& to, double step, const StopToken& stop = {});

}  // namespace glissade
