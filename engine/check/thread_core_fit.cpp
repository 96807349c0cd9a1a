#include "engine/check/thread_core_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade::check {
namespace {

constexpr double kSharpThread = 0.87;    ///< of the pitch
constexpr double kDeepestThread = 0.15;  ///< of the diameter
constexpr double kFarthest = std::numeric_limits<double>::infinity();

Diagnostic refused(const std::string& reason) { return {ErrorKind::NoPath, "", "", reason, "Plan again."}; }

}  // namespace

bool isThreadDepth(const ThreadDepth& depth) {
  const double deep = depth.radius - depth.core;
  return depth.core > 0.0 && deep > 0.0 && deep <= kSharpThread * std::abs(depth.pitch) &&
         deep <= kDeepestThread * 2.0 * depth.radius;
}

Result<ThreadCore> threadCoreOf(const ThreadSides& sides, const Thread& thread) {
  ThreadCore core{thread.point, thread.axis, kFarthest};
  const TriangleMesh& hole = sides.hole.mesh;
  for (std::size_t t = 0; t < hole.triangles.size(); ++t) {
    if (sides.ofHole.atMost[t] <= 0.0) continue;
    for (const std::uint32_t vertex : hole.triangles[t]) {
      core.radius = std::min(core.radius, core.distanceOf(hole.vertices[vertex]));
    }
  }
  if (core.radius == kFarthest || sides.ofShaft.most <= 0.0) return refused("nothing of its hole overlaps it");
  core.radius -= sides.ofShaft.largest.sum() - sides.ofShaft.largest.overlap;
  const TriangleMesh& shaft = sides.shaft.mesh;
  const std::vector<bool> ofThread = trianglesOfThread(shaft, sides.ofShaft.atMost, core);
  double crest = 0.0;
  for (std::size_t t = 0; t < ofThread.size(); ++t) {
    if (!ofThread[t]) continue;
    for (const std::uint32_t vertex : shaft.triangles[t])
      crest = std::max(crest, core.distanceOf(shaft.vertices[vertex]));
  }
  if (isThreadDepth({crest, core.radius, thread.pitch})) return core;
  return refused("what overlaps its hole is no thread of this pitch");
}

}  // namespace glissade::check
