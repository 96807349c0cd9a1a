#include "engine/fits/snap_ways.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/collision/collision_query.h"
#include "engine/evidence/hook.h"
#include "engine/evidence/placed_bodies.h"
#include "engine/fits/object_fits.h"

namespace glissade {
namespace {

/// Stated bends are rounded up to multiples of this, metres.
constexpr double kFineness = 1e-5;

/// Tries bends of the hooks of one body, with the shapes of the product's fits.
class BendTrial {
 public:
  BendTrial(const AssembledProduct& product, std::size_t body, const std::vector<std::size_t>& edges,
            const StopToken& stop)
      : product_(product), hook_(product.bodies[body]), body_(body), edges_(edges), stop_(stop) {
    for (const std::size_t edge : edges) {
      others_.extend(boxOf(edge));
      worlds_[edge] = CollisionWorld::build({product.bodies[edge]}, hook_.mesh);
    }
  }

  /// The least bend with which the body leaves, metres; nothing if `most` is not enough.
  std::optional<double> least(const Vector3& direction, double most) {
    if (leaves(direction, 0.0)) return 0.0;
    if (stop_.stopRequested() || !leaves(direction, most)) return std::nullopt;
    double tooLittle = 0.0;
    double enough = most;
    while (enough - tooLittle > kFineness) {
      const double middle = 0.5 * (tooLittle + enough);
      (leaves(direction, middle) ? enough : tooLittle) = middle;
    }
    return std::ceil(enough / kFineness) * kFineness;
  }

 private:
  Box3 boxOf(std::size_t body) const { return boundingBox(*product_.bodies[body].mesh, product_.bodies[body].X_WB); }

  bool leaves(const Vector3& direction, double bend) {
    return std::all_of(edges_.begin(), edges_.end(), [&](std::size_t edge) { return passes(edge, direction, bend); });
  }

  bool passes(std::size_t edge, const Vector3& direction, double bend) {
    const evidence::Body own = product_.measured(body_);
    const evidence::Body other = product_.measured(edge);
    evidence::FitWords words{true, 0.0, {}, {}};
    if (bend > 0.0) words.snaps = {{own.id, other.id, bend, direction}};
    const evidence::AllowanceBound bound =
        placed_.boundsOf({own, own.X_WB}, {other, other.X_WB}, words, nullptr, stop_).one;
    const ThinnableMesh* thinnable = thinnable_.of(bound.mesh ? bound.mesh : hook_.mesh);
    if (thinnable == nullptr) return false;
    const auto thinned = bound.most > 0.0 ? thinnable->thinned(bound.atMost, bound.share) : std::optional(*hook_.mesh);
    return thinned && slides(*thinned, edge, direction);
  }

  bool slides(const TriangleMesh& mesh, std::size_t edge, const Vector3& direction) const {
    const auto world = worlds_.at(edge)->withObject(std::make_shared<const TriangleMesh>(mesh));
    Pose end = hook_.X_WB;
    end.position += (boxOf(body_).sizes() + others_.sizes()).norm() * direction;
    const double required = 0.25 * assembledGap(radiusAboutOrigin(*hook_.mesh));
    return world->makeQuery()->checkMotion(hook_.X_WB, end, required, SeekViolation::Any, stop_).status ==
           CertificateStatus::Certified;
  }

  const AssembledProduct& product_;
  const RigidBody& hook_;
  std::size_t body_;
  const std::vector<std::size_t>& edges_;
  const StopToken& stop_;
  Box3 others_;
  std::map<std::size_t, CollisionWorldPtr> worlds_;  ///< one for each edge
  evidence::PlacedBodies placed_;
  ThinnableBodies thinnable_;
};

}  // namespace

std::vector<SnapWay> snapWays(const AssembledProduct& product, std::size_t body, const std::vector<std::size_t>& edges,
                              const StopToken& stop) {
  BendTrial trial(product, body, edges, stop);
  const double most = evidence::mostBendOf(*product.bodies[body].mesh);
  std::vector<SnapWay> ways;
  for (int axis = 0; axis < 6 && !stop.stopRequested(); ++axis) {
    const Vector3 direction = (axis % 2 == 0 ? 1.0 : -1.0) * Vector3::Unit(axis / 2);
    if (const auto bend = trial.least(direction, most)) ways.push_back({direction, *bend});
  }
  return ways;
}

std::optional<double> leastBend(const AssembledProduct& product, std::size_t body,
                                const std::vector<std::size_t>& edges, const Vector3& direction,
                                const StopToken& stop) {
  return BendTrial(product, body, edges, stop).least(direction, evidence::mostBendOf(*product.bodies[body].mesh));
}

bool keepsToWay(const Vector3& way, const RigidBody& body, const std::vector<Pose>& path, const RigidBody& other) {
  return evidence::goesAlong(way, {body.id, body.name, body.mesh, body.X_WB}, path,
                             {other.id, other.name, other.mesh, other.X_WB});
}

}  // namespace glissade
