#include "engine/product/core_fit.h"

#include <algorithm>
#include <limits>

#include "engine/check/thread_core_fit.h"
#include "engine/product/shaft_helix.h"

namespace glissade {
namespace {

/// What a corner may be farther from the axis than it was computed to be, metres.
constexpr double kRounding = 1e-9;

bool isScrew(const TurnedShape& shape) {
  return shape.kind == TurnedKind::Screw || shape.kind == TurnedKind::SetScrew || shape.kind == TurnedKind::Rod;
}

}  // namespace

std::optional<double> ModelledPitches::of(const MeshPtr& mesh) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = pitches_.find(mesh); known != pitches_.end()) return known->second;
  }
  const AxialMesh axial(*mesh);
  const auto shape = turnedShapeOf(*mesh, axial);
  const auto pitch = shape && isScrew(*shape) ? modelledPitch(axial, *shape) : std::nullopt;
  const std::lock_guard lock(mutex_);
  return pitches_.try_emplace(mesh, pitch).first->second;
}

std::optional<CoreFit> coreFitOf(const CoreQuestion& question, ThinnableBodies& thinnable) {
  const check::AllowanceBound& bound = question.ofShaft;
  if (bound.most <= 0.0) return std::nullopt;
  const Pose X_SW = inverse(question.shaft.X_WB);
  ThreadCore core{X_SW * question.axis.point, X_SW.orientation * question.axis.direction.normalized(), 0.0};
  const TriangleMesh& hole = *question.hole.mesh;
  const Pose X_SH = X_SW * question.hole.X_WB;
  CoreFit fit;
  fit.radiusOfHole = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < hole.triangles.size(); ++t) {
    if (question.ofHole.atMost[t] <= 0.0) continue;
    for (const std::uint32_t vertex : hole.triangles[t]) {
      fit.radiusOfHole = std::min(fit.radiusOfHole, core.distanceOf(X_SH * hole.vertices[vertex]));
    }
  }
  core.radius = fit.radiusOfHole - (bound.largest.sum() - bound.largest.overlap);
  const TriangleMesh& shaft = *question.shaft.mesh;
  const std::vector<bool> ofThread = trianglesOfThread(shaft, bound.atMost, core);
  for (std::size_t t = 0; t < ofThread.size(); ++t) {
    if (!ofThread[t]) continue;
    for (const std::uint32_t vertex : shaft.triangles[t]) {
      fit.radiusOfShaft = std::max(fit.radiusOfShaft, core.distanceOf(shaft.vertices[vertex]));
    }
  }
  if (!check::isThreadDepth({fit.radiusOfShaft, core.radius, question.pitch})) return std::nullopt;
  fit.allowance = std::min(bound.most, fit.radiusOfShaft - core.radius + kRounding);
  std::vector<double> allowances = bound.atMost;
  for (double& each : allowances) each = std::min(each, fit.allowance);
  fit.core = thinnable.withoutThread(question.shaft.mesh, allowances, core);
  return fit.core ? std::optional(std::move(fit)) : std::nullopt;
}

}  // namespace glissade
