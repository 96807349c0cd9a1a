#include "tests/benchmarks/six_axes.h"

#include <array>
#include <limits>
#include <map>
#include <optional>

#include "engine/collision/prepared_bodies.h"
#include "engine/geometry/thinned_mesh.h"

namespace glissade {
namespace {

constexpr double kAllowedPenetration = 1.5e-4;
constexpr int kSamples = 400;
constexpr double kMargin = 1e-3;
constexpr double kApart = 1e-6;
constexpr std::array<double, 9> kDepths{1.5e-4, 2e-4, 3e-4, 5e-4, 7.5e-4, 1e-3, 1.5e-3, 2e-3, 3e-3};

/// The body itself where it cannot be thinned so.
MeshPtr thinnedBy(double depth, const MeshPtr& mesh) {
  const auto thinnable = ThinnableMesh::of(*mesh);
  auto thinner = thinnable ? thinnable->thinned(depth) : std::nullopt;
  return thinner ? std::make_shared<const TriangleMesh>(std::move(*thinner)) : mesh;
}

/// Those whose boxes meet the body's on its way.
std::vector<PreparedBodies::Against> nearWay(PreparedBodies& prepared, std::size_t body, const Vector3& way,
                                             const BodySet& others, const MeshPtr& mesh) {
  const Box3& box = prepared.boxOf(body);
  Box3 swept = box;
  swept.extend(Box3(box.min() + way, box.max() + way));
  std::vector<PreparedBodies::Against> near;
  for (const std::size_t other : bodiesIn(others)) {
    if (swept.intersects(prepared.boxOf(other))) near.push_back({other, mesh});
  }
  return near;
}

class SixAxes {
 public:
  explicit SixAxes(const AssembledProduct& product) : product_(product), prepared_(product.bodies) {}

  std::optional<SixAxesStep> leave(std::size_t body, const BodySet& others, const StopToken& stop) {
    const Box3 rest = boxOf(product_, others);
    const Box3& box = prepared_.boxOf(body);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const double length = sign > 0.0 ? rest.max()[axis] - box.min()[axis] : box.max()[axis] - rest.min()[axis];
        const Vector3 way = sign * (std::max(0.0, length) + kMargin) * Vector3::Unit(axis);
        if (stop.stopRequested()) return std::nullopt;
        if (isFree(body, way, others)) return SixAxesStep{body, way, others};
      }
    }
    return std::nullopt;
  }

 private:
  bool isFree(std::size_t body, const Vector3& way, const BodySet& others) {
    const RigidBody& own = product_.bodies[body];
    MeshPtr& thin = thin_[own.mesh];
    if (!thin) thin = thinnedBy(kAllowedPenetration, own.mesh);
    const auto world = prepared_.world(thin, nearWay(prepared_, body, way, others, thin));
    const auto query = world->makeQuery();
    for (int i = 0; i <= kSamples; ++i) {
      Pose at = own.X_WB;
      at.position += static_cast<double>(i) / kSamples * way;
      if (query->collides(at)) return false;
    }
    return true;
  }

  const AssembledProduct& product_;
  PreparedBodies prepared_;
  std::map<MeshPtr, MeshPtr> thin_;
};

}  // namespace

std::vector<SixAxesStep> sixAxesSequence(const AssembledProduct& product, const BodySet& staying,
                                         const StopToken& stop) {
  SixAxes axes(product);
  BodySet present(product.bodies.size(), true);
  std::vector<SixAxesStep> steps;
  for (bool left = true; left;) {
    left = false;
    for (const std::size_t body : bodiesIn(present)) {
      if (staying[body]) continue;
      auto step = axes.leave(body, without(present, {body}), stop);
      if (!step) continue;
      present[body] = false;
      steps.push_back(std::move(*step));
      left = true;
    }
  }
  return steps;
}

double penetrationOf(const AssembledProduct& product, const SixAxesStep& step, const StopToken& stop) {
  const RigidBody& own = product.bodies[step.body];
  PreparedBodies prepared(product.bodies);
  Pose end = own.X_WB;
  end.position += step.way;
  const auto provedFree = [&](const MeshPtr& mesh) {
    const auto world = prepared.world(mesh, nearWay(prepared, step.body, step.way, step.others, mesh));
    const auto check = world->makeQuery()->checkMotion(own.X_WB, end, kApart, SeekViolation::Any, stop);
    return check.status == CertificateStatus::Certified;
  };
  if (provedFree(own.mesh)) return 0.0;
  for (const double depth : kDepths) {
    const MeshPtr thin = thinnedBy(depth, own.mesh);
    if (thin != own.mesh && provedFree(thin)) return depth;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace glissade
