#include "engine/evidence/thread_core.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/evidence/crest_helix.h"
#include "engine/evidence/evidence.h"
#include "engine/evidence/round_faces.h"
#include "engine/evidence/thread.h"
#include "engine/evidence/turn.h"

namespace glissade::evidence {
namespace {

/// At either end a thread runs out: crests are compared so many pitches away from there.
constexpr double kRunOut = 0.25;
/// A sharp thread of 60 degrees (ISO 68-1: H = 0.866 P), and the share of the diameter that M1.6 has 0.13 of.
constexpr double kSharpThread = 0.866;
constexpr double kDeepest = 0.15;
/// Radius of the widest wall of a hole, as a share of the crest's radius. A countersink may be wider.
constexpr double kWidestWall = 1.25;
constexpr double kSameHeight = 1e-9;

struct Span {
  double low;
  double high;
};

/// The radii of the narrowest ring of vertices around the axis; nothing if there is none.
std::optional<Span> ringAround(std::vector<Around> vertices, const Span& radii) {
  std::sort(vertices.begin(), vertices.end(), [](const Around& a, const Around& b) { return a.radius < b.radius; });
  const auto from = [&](double radius) {
    return std::lower_bound(vertices.begin(), vertices.end(), radius,
                            [](const Around& vertex, double value) { return vertex.radius < value; });
  };
  auto first = from(radii.low);
  while (first != vertices.end() && first->radius <= radii.high) {
    const double off = vertexTolerance(first->radius);
    const auto last = from(first->radius + 2.0 * off);
    Span span{first->height, first->height};
    for (auto each = first; each != last; ++each) {
      span = {std::min(span.low, each->height), std::max(span.high, each->height)};
    }
    if (areAround({first, last})) return span;
    first = from(first->radius + off);
  }
  return std::nullopt;
}

/// Range of the grooves that begin beside the hole's wall and continue without a gap of a pitch.
std::optional<Span> threadSpan(const std::vector<Around>& shaft, const Span& wall, double hole,
                               const ClaimedThread& claim) {
  const double pitch = std::abs(claim.pitch);
  std::vector<double> heights;
  for (const Around& vertex : shaft) {
    if (vertex.radius <= hole && vertex.radius >= claim.crest - kSharpThread * pitch) heights.push_back(vertex.height);
  }
  std::sort(heights.begin(), heights.end());
  const auto first = std::lower_bound(heights.begin(), heights.end(), wall.low - 0.5 * pitch);
  if (first == heights.end() || *first > wall.high + 0.5 * pitch) return std::nullopt;
  auto low = first;
  while (low != heights.begin() && *low - *std::prev(low) <= pitch) --low;
  auto high = first;
  while (std::next(high) != heights.end() && *std::next(high) - *high <= pitch) ++high;
  return Span{*low, *high};
}

/// Least distance of the body from the axis within the span; triangles count as a whole.
double freeRadius(const PlacedBody& hole, const ClaimedThread& claim, const Span& span) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : hole.tree.triangles()) {
    const TurnedTriangle passed = turned(a, b, c, claim.point, claim.axis);
    if (passed.high >= span.low && passed.low <= span.high) least = std::min(least, passed.nearest);
  }
  return least;
}

/// Extends a thread that ends within a pitch of the shaft's end to that end, where the tip has a chamfer.
Span toTheEnds(Span thread, const std::vector<Around>& shaft, double pitch) {
  const auto [lowest, highest] = std::minmax_element(
      shaft.begin(), shaft.end(), [](const Around& a, const Around& b) { return a.height < b.height; });
  if (lowest->height >= thread.low - pitch) thread.low = lowest->height;
  if (highest->height <= thread.high + pitch) thread.high = highest->height;
  return thread;
}

/// Vertices at the crest's radius, outside of the thread's run-out.
std::vector<Around> crestsOf(const std::vector<Around>& shaft, const Span& thread, const ClaimedThread& claim) {
  const double runOut = kRunOut * std::abs(claim.pitch);
  std::vector<Around> crests;
  for (const Around& vertex : shaft) {
    if (std::abs(vertex.radius - claim.crest) > vertexTolerance(claim.crest)) continue;
    if (vertex.height >= thread.low + runOut && vertex.height <= thread.high - runOut) crests.push_back(vertex);
  }
  std::sort(crests.begin(), crests.end(), [](const Around& a, const Around& b) { return a.height < b.height; });
  return crests;
}

Diagnostic refused(const Message& reason) { return {ErrorKind::NoPath, "", "", reason, GLISSADE_TEXT("Plan again.")}; }

}  // namespace

Result<ThreadCore> threadCoreOf(const PlacedBody& shaft, const PlacedBody& hole, ClaimedThread claim) {
  claim.axis.normalize();
  Thread rule;
  rule.pitch = claim.pitch;
  rule.radiusMoving = claim.crest;
  if (const Message wrong = wrongPitch(rule); !wrong.empty()) return refused(wrong);
  const auto wall =
      ringAround(aroundOf(hole.mesh, claim.point, claim.axis), {0.5 * claim.crest, kWidestWall * claim.crest});
  if (!wall) return refused(GLISSADE_TEXT("the hole is not around the axis that the file states for the thread"));
  const std::vector<Around> vertices = aroundOf(shaft.mesh, claim.point, claim.axis);
  const auto claimed = threadSpan(vertices, *wall, claim.crest, claim);
  const double free = claimed ? freeRadius(hole, claim, *claimed) : 0.0;
  const auto thread = threadSpan(vertices, *wall, free, claim);
  if (!thread) return refused(GLISSADE_TEXT("the shaft has no groove that is as narrow as the hole"));
  const std::vector<Around> crests = crestsOf(vertices, *thread, claim);
  if (!ringAround(crests, {claim.crest - vertexTolerance(claim.crest), claim.crest}))
    return refused(GLISSADE_TEXT("the crests are not around the axis that the file states"));
  const auto helix = helixOfLead(crests, claim.pitch);
  if (!helix) return refused(GLISSADE_TEXT("the shaft has no helix of the pitch that the file states"));
  const Span taken = toTheEnds(*thread, vertices, std::abs(claim.pitch));
  ThreadCore core{claim.point, claim.axis, taken.low, taken.high};
  core.crest = claim.crest + vertexTolerance(claim.crest);
  core.hole = free;
  core.spacing = shaft.spacing + hole.spacing;
  core.margin = assembledMargin(std::max({shaft.radius, shaft.halfDiagonal, hole.radius, hole.halfDiagonal})) +
                kThreadPlay * std::abs(claim.pitch);
  core.radius = free - core.spacing - core.margin;
  const double deep = claim.crest - core.radius;
  const double most = std::min(kSharpThread * std::abs(helix->pitch()), kDeepest * 2.0 * claim.crest);
  if (core.radius > 0.0 && deep > 0.0 && deep <= most) return core;
  return refused(GLISSADE_TEXT("what of the shaft is wider than the hole is no thread of this pitch"));
}

std::vector<bool> trianglesOfThread(const TriangleMesh& shaft, const ThreadCore& core) {
  const std::vector<Around> vertices = aroundOf(shaft, core.point, core.axis);
  std::vector<bool> ofThread;
  for (const TriangleIndices& triangle : shaft.triangles) {
    ofThread.push_back(std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t i) {
      const Around& at = vertices[i];
      return at.radius <= core.crest && at.height >= core.low - kSameHeight && at.height <= core.high + kSameHeight;
    }));
  }
  return ofThread;
}

TriangleMesh withoutThread(const TriangleMesh& mesh, const ThreadCore& core) {
  TriangleMesh shaft = welded(mesh);
  const std::vector<Around> vertices = aroundOf(shaft, core.point, core.axis);
  std::vector<bool> stays;
  for (const Around& at : vertices) stays.push_back(at.radius > core.crest || at.radius <= core.radius);
  for (const TriangleIndices& triangle : shaft.triangles) {
    const bool reachesBeyond = std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t i) {
      return vertices[i].height < core.low - kSameHeight || vertices[i].height > core.high + kSameHeight;
    });
    if (!reachesBeyond) continue;
    for (const std::uint32_t i : triangle) stays[i] = true;
  }
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (stays[i]) continue;
    const Vector3 arm = shaft.vertices[i] - core.point;
    const Vector3 across = arm - arm.dot(core.axis) * core.axis;
    shaft.vertices[i] -= (1.0 - core.radius / vertices[i].radius) * across;
  }
  return shaft;
}

ThreadCore inFrame(const Pose& X_FW, ThreadCore core) {
  core.point = X_FW * core.point;
  core.axis = X_FW.orientation * core.axis;
  return core;
}

}  // namespace glissade::evidence
