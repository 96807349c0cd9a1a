#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/check/motion_check.h"
#include "engine/check/thinning.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/thread_rule.h"
#include "engine/product/object_fits.h"
#include "engine/scenario/judged_product.h"

namespace glissade {

/// Metres by which each triangle of the object is thinner against each obstacle; an empty list: the object is whole.
using FaceAllowances = std::vector<std::vector<double>>;

/// All of the object is thinner by one allowance against each obstacle.
inline FaceAllowances everywhere(const std::vector<double>& allowances, const TriangleMesh& object) {
  FaceAllowances all;
  for (const double allowance : allowances) all.emplace_back(allowance > 0.0 ? object.triangles.size() : 0, allowance);
  return all;
}

/// As planners take the object against each of so many obstacles.
inline FaceAllowances allowancesOf(const std::vector<Fit>& fits, std::size_t obstacles) {
  FaceAllowances all(obstacles);
  for (const Fit& fit : fits) {
    if (fit.thinned) all[fit.obstacle] = limited(fit.bounds->one.atMost, fit.allowance);
  }
  return all;
}

/// The judge of motions with the planners' values, so that tests compare the two.
class IndependentCheck {
 public:
  IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                   const FaceAllowances& allowances = {}, const std::vector<ThreadRule>& threads = {}) {
    std::map<std::vector<double>, MeshPtr> objects{{{}, std::make_shared<const TriangleMesh>(object)}};
    std::vector<const TriangleMesh*> meshes;
    for (const std::vector<double>& each : allowances) {
      MeshPtr& thinner = objects[each];
      if (!thinner) thinner = std::make_shared<const TriangleMesh>(check::thinned(object, each));
    }
    for (const auto& [allowance, mesh] : objects) meshes.push_back(mesh.get());
    for (const RigidBody& body : obstacles) meshes.push_back(body.mesh.get());
    const double scale = check::MotionCheck::scaleFor(meshes, judgedBodies(obstacles));
    std::vector<check::MotionCheck::Against> against;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      const std::vector<double> ofPair = i < allowances.size() ? allowances[i] : std::vector<double>();
      const auto prepared = check::MotionCheck::prepare(*obstacles[i].mesh, obstacles[i].X_WB, scale);
      against.push_back({prepared, objects[ofPair], !ofPair.empty()});
    }
    std::vector<check::MotionCheck::Threaded> threaded;
    for (const ThreadRule& rule : threads) {
      const auto number = static_cast<std::size_t>(rule.obstacle);
      threaded.push_back({threadOf(rule), obstacles[number].mesh, obstacles[number].X_WB, against[number].obstacle});
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

  std::string whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const {
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
  static check::Thread threadOf(const ThreadRule& rule) {
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
