#include "engine/fits/core_fit.h"

#include <algorithm>
#include <set>

#include "engine/fits/common_axis.h"
#include "engine/fits/shaft_helix.h"

namespace glissade {
namespace {

bool isScrew(const TurnedShape& shape) {
  return shape.kind == TurnedKind::Screw || shape.kind == TurnedKind::SetScrew || shape.kind == TurnedKind::Rod;
}

/// Position of a point about the thread's axis.
struct InThread {
  InThread(const evidence::ThreadCore& core, const Vector3& p) : across(p - core.point) {
    const double along = across.dot(core.axis);
    across -= along * core.axis;
    isWithin = along >= core.low - kSame && along <= core.high + kSame;
  }
  static constexpr double kSame = 1e-9;
  Vector3 across;
  bool isWithin = false;
};

/// Allowances of faces of the shaft beside the thread that touch the other body.
std::vector<double> besideThread(const CoreSide& shaft, const CoreSide& hole, const evidence::ThreadCore& core) {
  const double touching = core.spacing + core.margin + shaft.placed.largestDeflection + hole.placed.largestDeflection;
  const std::vector<bool> ofThread = evidence::trianglesOfThread(shaft.placed.mesh, core);
  std::vector<double> allowances = evidence::mostOfTriangles(shaft.bound, shaft.placed.mesh.triangles.size());
  for (std::size_t t = 0; t < allowances.size(); ++t) {
    allowances[t] = ofThread[t] ? 0.0 : std::min(allowances[t], touching);
  }
  return allowances;
}

/// Moves corners of the teeth onto the core; corners that they share with shank or head stay.
TriangleMesh ontoCore(TriangleMesh mesh, const evidence::ThreadCore& core) {
  std::vector<Vector3> moved = mesh.vertices;
  for (Vector3& p : moved) {
    const InThread at(core, p);
    const double distance = at.across.norm();
    if (distance > core.radius && distance <= core.crest) p -= (1.0 - core.radius / distance) * at.across;
  }
  const auto isWithin = [&](std::uint32_t i) { return InThread(core, mesh.vertices[i]).isWithin; };
  for (const TriangleIndices& triangle : mesh.triangles) {
    if (std::all_of(triangle.begin(), triangle.end(), isWithin)) continue;
    for (const std::uint32_t i : triangle) moved[i] = mesh.vertices[i];
  }
  mesh.vertices = std::move(moved);
  return mesh;
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

std::optional<CoreFit> coreFitOf(const CoreSide& shaft, const CoreSide& hole, double pitch,
                                 ThinnableBodies& thinnable) {
  std::set<double> tried;
  for (ContactAxis axis : commonAxesOf(shaft.body, hole.body)) {
    if (!axis.shaftIsA || !tried.insert(axis.radiusA).second) continue;
    const auto core =
        evidence::threadCoreOf(shaft.placed, hole.placed, {axis.point, axis.direction, pitch, axis.radiusA});
    if (!core) continue;
    axis.radiusB = core->hole;
    const std::vector<double> beside = besideThread(shaft, hole, *core);
    const bool touches = std::any_of(beside.begin(), beside.end(), [](double each) { return each > 0.0; });
    const MeshPtr thinned = touches ? thinnable.thinned(shaft.body.mesh, beside) : shaft.body.mesh;
    if (!thinned) return std::nullopt;
    const evidence::ThreadCore own = evidence::inFrame(inverse(shaft.body.X_WB), *core);
    return CoreFit{*core, std::make_shared<const TriangleMesh>(ontoCore(welded(*thinned), own)), axis};
  }
  return std::nullopt;
}

}  // namespace glissade
