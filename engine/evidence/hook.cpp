#include "engine/evidence/hook.h"

#include <algorithm>
#include <cmath>

#include "engine/evidence/part_cells.h"

namespace glissade::evidence {
namespace {

/// Limits of the grid points along an edge of a triangle.
constexpr int kFewestSteps = 2;
constexpr int kMostSteps = 24;
/// Distance, metres, by which sample points are moved inwards, in addition to deviations of files and coordinates:
/// faces along which the other body slides do not block it.
constexpr double kSlides = 1e-5;
/// Spacing of the grid, as a share of half of the diagonal of the hook's body; half of the bend if that is less.
constexpr double kFineShare = 0.02;
/// A face belongs to a hook if at least this share of it blocks the other body.
constexpr double kHookFaceShare = 0.25;
/// Cosine between the normal of a face and the exit direction above which the face catches. The hook bends across that
/// direction.
constexpr double kCatches = 0.9;
/// A path goes along the direction if it turns by at most kTurns, radians, and its cosine is at least kAlong.
constexpr double kTurns = 1e-6;
constexpr double kAlong = 1.0 - 1e-6;
constexpr double kMiddle = 1.0 / 3.0;  ///< share of a cell of the grid

double areaOf(const Triangle& t) { return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm(); }

int stepsFor(const Triangle& triangle, double spacing) {
  return static_cast<int>(
      std::clamp(std::ceil(longestEdge(triangle) / spacing), double{kFewestSteps}, double{kMostSteps}));
}

class HookSearch {
 public:
  explicit HookSearch(const HookQuestion& question)
      : question_(question),
        below_(kSlides + question.hook.spacing + question.edge.spacing + question.hook.largestDeflection +
               question.edge.largestDeflection),
        spacing_(std::min(0.5 * question.bend, kFineShare * question.hook.halfDiagonal)) {}

  /// Area of the triangle that blocks the other body, by sample points, square metres.
  double areaInTheWay(std::uint32_t number) const {
    const Triangle& triangle = question_.hook.tree.triangles()[number];
    if (question_.hook.normals[number].dot(question_.direction) > kCatches) return 0.0;
    const Vector3 inset = -below_ * question_.hook.normals[number];
    const int steps = stepsFor(triangle, spacing_);
    int points = 0;
    int hit = 0;
    for (int i = 0; i < steps; ++i) {
      for (int k = 0; i + k < steps; ++k) {
        const Vector3 along = (triangle[1] - triangle[0]) * (i + kMiddle) / steps;
        const Vector3 across = (triangle[2] - triangle[0]) * (k + kMiddle) / steps;
        ++points;
        if (isHit(triangle[0] + along + across + inset)) ++hit;
      }
    }
    return areaOf(triangle) * hit / points;
  }

 private:
  bool isHit(const Vector3& p) const {
    return std::isfinite(question_.edge.tree.firstHit(p, question_.direction, 0.0));
  }

  const HookQuestion& question_;
  double below_;    ///< depth of the sample points, metres
  double spacing_;  ///< spacing of the grid, metres
};

}  // namespace

bool goesAlong(const Vector3& direction, const Body& body, const std::vector<Pose>& path, const Body& other) {
  const Box3 box = boundingBox(*other.mesh, other.X_WB);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vector3 way = path[i + 1].position - path[i].position;
    const bool turns = path[i].orientation.angularDistance(path[i + 1].orientation) > kTurns;
    Box3 swept = boundingBox(*body.mesh, path[i]).merged(boundingBox(*body.mesh, path[i + 1]));
    if (turns) {
      // For up to half a circle, no point of the body is farther than this from its first or last place.
      const Vector3 beside = Vector3::Constant(2.0 * radiusAboutOrigin(*body.mesh) + 0.5 * way.norm());
      swept = Box3(swept.min() - beside, swept.max() + beside);
    }
    if (!swept.intersects(box)) continue;
    if (turns || way.dot(direction) < kAlong * way.norm()) return false;
  }
  return true;
}

std::vector<bool> hookRegions(const HookQuestion& question, const StopToken& stop) {
  const HookSearch search(question);
  std::vector<double> areas(question.hook.regions.count, 0.0);
  std::vector<double> inTheWay(question.hook.regions.count, 0.0);
  for (std::uint32_t t = 0; t < question.hook.normals.size() && !stop.stopRequested(); ++t) {
    const std::uint32_t region = question.hook.regions.of[t];
    areas[region] += areaOf(question.hook.tree.triangles()[t]);
    inTheWay[region] += search.areaInTheWay(t);
  }
  std::vector<bool> regions;
  for (std::size_t r = 0; r < areas.size(); ++r) {
    regions.push_back(inTheWay[r] > 0.0 && inTheWay[r] >= kHookFaceShare * areas[r]);
  }
  return regions;
}

}  // namespace glissade::evidence
