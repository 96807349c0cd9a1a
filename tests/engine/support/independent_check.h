#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/motion_check.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/thread_rule.h"
#include "engine/evidence/thinning.h"
#include "engine/files/judged_product.h"
#include "engine/fits/fit_words.h"
#include "engine/fits/object_fits.h"

namespace glissade {

/// Metres by which each triangle of a body is thinner against an obstacle; an empty list: the body is whole.
struct ThinnerFaces {
  std::vector<double> allowances{};
  MeshPtr mesh{};  ///< of these triangles; null: the body's own

  bool operator<(const ThinnerFaces& b) const { return std::tie(allowances, mesh) < std::tie(b.allowances, b.mesh); }
  TriangleMesh of(const TriangleMesh& body) const { return evidence::thinned(mesh ? *mesh : body, allowances); }
};
/// The faces of the object against each obstacle.
using FaceAllowances = std::vector<ThinnerFaces>;

/// All of the object is thinner by one allowance against each obstacle.
inline FaceAllowances everywhere(const std::vector<double>& allowances, const TriangleMesh& object) {
  FaceAllowances all;
  for (const double allowance : allowances) {
    all.push_back({std::vector<double>(allowance > 0.0 ? object.triangles.size() : 0, allowance)});
  }
  return all;
}

/// The faces of the body that the fit takes thinner, while the last body of the product moves.
inline ThinnerFaces faceAllowances(const Fit& fit, const AssembledProduct& product) {
  const auto bodyAt = [&](std::size_t index) {
    const RigidBody& body = product.bodies[index];
    return evidence::Body{
        body.id, body.name, body.mesh, body.X_WB, product.spacingOf(index), product.deflections[index]};
  };
  const evidence::Body object = bodyAt(product.bodies.size() - 1);
  const evidence::Body other = bodyAt(fit.obstacle);
  const evidence::FitWords words = wordsOf(product.fits);
  evidence::PlacedBodies placed;
  const evidence::PairBounds bounds =
      placed.boundsOf({object, object.X_WB}, {other, other.X_WB}, words, words.about(object.id, other.id), {});
  const evidence::AllowanceBound& bound = fit.yields ? bounds.other : bounds.one;
  ThinnerFaces faces{bound.atMost, bound.mesh};
  for (double& each : faces.allowances) each = std::min(each, fit.allowance);
  return faces;
}

/// The allowances of the object, the product's last body, against each other body, as planners apply them.
inline FaceAllowances allowancesOf(const std::vector<Fit>& fits, const AssembledProduct& product) {
  FaceAllowances all(product.bodies.size() - 1);
  for (const Fit& fit : fits) {
    if (fit.thinned && !fit.yields) all[fit.obstacle] = faceAllowances(fit, product);
  }
  return all;
}

/// The others as planners take them: those that give way are thinned by the judge's own code.
inline std::vector<RigidBody> obstaclesOf(const std::vector<Fit>& fits, const AssembledProduct& product) {
  std::vector<RigidBody> obstacles(product.bodies.begin(), product.bodies.end() - 1);
  for (const Fit& fit : fits) {
    if (!fit.thinned || !fit.yields) continue;
    MeshPtr& mesh = obstacles[fit.obstacle].mesh;
    mesh = std::make_shared<const TriangleMesh>(faceAllowances(fit, product).of(*mesh));
  }
  return obstacles;
}

/// The judge of motions with the planners' values, so that tests compare the two.
class IndependentCheck {
 public:
  IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                   const FaceAllowances& allowances = {}, const std::vector<ThreadRule>& threads = {})
      : IndependentCheck(obstacles, obstacles, object, allowances, threads) {}

  /// The product's last body among the others, taken as its fits have it.
  IndependentCheck(const std::vector<Fit>& fits, const AssembledProduct& product,
                   const std::vector<ThreadRule>& threads)
      : IndependentCheck(obstaclesOf(fits, product), {product.bodies.begin(), product.bodies.end() - 1},
                         *product.bodies.back().mesh, allowancesOf(fits, product), threads) {}

  /// `taken`: the obstacles, where some give way.
  IndependentCheck(const std::vector<RigidBody>& taken, const std::vector<RigidBody>& obstacles,
                   const TriangleMesh& object, const FaceAllowances& allowances,
                   const std::vector<ThreadRule>& threads) {
    std::map<ThinnerFaces, MeshPtr> objects{{{}, std::make_shared<const TriangleMesh>(object)}};
    std::vector<const TriangleMesh*> meshes;
    for (const ThinnerFaces& each : allowances) {
      MeshPtr& thinner = objects[each];
      if (!thinner) thinner = std::make_shared<const TriangleMesh>(each.of(object));
    }
    for (const auto& [allowance, mesh] : objects) meshes.push_back(mesh.get());
    for (const RigidBody& body : obstacles) meshes.push_back(body.mesh.get());
    for (const RigidBody& body : taken) meshes.push_back(body.mesh.get());
    const double scale = check::MotionCheck::scaleFor(meshes, judgedBodies(obstacles));
    std::vector<check::MotionCheck::Against> against;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      const ThinnerFaces ofPair = i < allowances.size() ? allowances[i] : ThinnerFaces();
      const auto prepared = check::MotionCheck::prepare(*taken[i].mesh, taken[i].X_WB, scale);
      against.push_back({prepared, objects[ofPair]});
    }
    std::vector<check::MotionCheck::Threaded> threaded;
    for (const ThreadRule& rule : threads) {
      const auto number = static_cast<std::size_t>(rule.obstacle);
      const RigidBody& whole = obstacles[number];
      const auto prepared = check::MotionCheck::prepare(*whole.mesh, whole.X_WB, scale);
      threaded.push_back({threadOf(rule), whole.mesh, whole.X_WB, prepared});
    }
    check_ = std::make_shared<const check::MotionCheck>(against, object, scale, threaded);
  }

  MotionCertificate check(const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                          const StopToken& stop = {}) const {
    std::vector<check::Demand> judged;
    for (const EdgeDemand& demand : demands) judged.push_back({demand.clearance, demand.sliding});
    const check::MotionVerdict verdict = check_->check(path, judged, WorkWatch(stop));
    MotionCertificate certificate;
    certificate.status = statusOf(verdict.status);
    certificate.tolerance = verdict.demanded;
    certificate.minClearance = verdict.minClearance;
    certificate.provedClearance = verdict.provedClearance;
    certificate.edge = verdict.edge;
    certificate.at = verdict.at;
    certificate.nearest = nearestOf(verdict.nearest);
    certificate.againstThread = verdict.againstThread;
    certificate.distanceQueries = verdict.distances;
    for (const check::EdgeVerdict& edge : verdict.edges) {
      certificate.edges.push_back({statusOf(edge.status),
                                   {edge.demand.clearance, edge.demand.sliding},
                                   edge.provedClearance,
                                   edge.minClearance,
                                   edge.at,
                                   nearestOf(edge.nearest)});
    }
    return certificate;
  }

  Message whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const {
    return check_->whyUndecided(from, to, requiredClearance);
  }

 private:
  static CertificateStatus statusOf(check::Status status) {
    if (status == check::Status::Certified) return CertificateStatus::Certified;
    return status == check::Status::Violated ? CertificateStatus::Violated : CertificateStatus::Undecided;
  }
  static NearestObstacle nearestOf(const check::Nearest& nearest) {
    return {nearest.distance, nearest.body, nearest.onBody, nearest.onMoving};
  }
  static evidence::Thread threadOf(const ThreadRule& rule) {
    return {static_cast<std::size_t>(rule.obstacle),
            rule.point_W,
            rule.axis_W,
            rule.pitch,
            rule.radiusOfObject,
            rule.radiusOfObstacle,
            rule.objectIsShaft,
            rule.mayTurn,
            rule.assembled.front()};
  }

  std::shared_ptr<const check::MotionCheck> check_;
};

}  // namespace glissade
