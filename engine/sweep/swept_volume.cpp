#include "engine/sweep/swept_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/collision/motion_bound.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/sweep/enclosing_values.h"
#include "engine/sweep/lattice.h"
#include "engine/sweep/level_surface.h"
#include "engine/sweep/sweep_clearances.h"

namespace glissade {
namespace {

/// The point of the lattice at which the cell with p begins.
std::array<int, 3> cellAt(const Lattice& lattice, const Vector3& p) {
  std::array<int, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<int>(axis);
    const double along = std::floor((p[a] - lattice.origin[a]) / lattice.spacing);
    cell[axis] = std::clamp(static_cast<int>(along), 0, lattice.counts[axis] - 2);
  }
  return cell;
}

/// No point of a surface through the cells of a lattice is farther from the body, at its nearest, than this; metres.
/// Precondition: each triangle has a corner of the lattice near it at which the clearance is below the reach.
double farthestFromBody(const TriangleMesh& surface_W, const Lattice& lattice, const SweepClearances& clearances) {
  const double reach = static_cast<float>(SweepClearances::kReach * lattice.spacing);
  const double slack = SweepClearances::kSlack * lattice.spacing;
  double farthest = 0.0;
  for (const TriangleIndices& triangle : surface_W.triangles) {
    Vector3 sum = Vector3::Zero();
    for (const std::uint32_t vertex : triangle) sum += surface_W.vertices[vertex];
    const std::array<int, 3> cell = cellAt(lattice, sum / 3.0);
    // Distances from a corner, and so what they bound, are largest at a vertex of the triangle.
    double nearest = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
      const std::size_t point = lattice.cornerAt(cell, corner);
      if (clearances.values[point] >= reach) continue;
      const auto [x, y, z] = lattice.coordinates(point);
      double away = 0.0;
      for (const std::uint32_t vertex : triangle) {
        away = std::max(away, (surface_W.vertices[vertex] - lattice.point(x, y, z)).norm());
      }
      nearest = std::min(nearest, clearances.values[point] + slack + away);
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// Spacings: the bound that surfaces have, mostly. Where one has more, a finer lattice is taken.
constexpr double kBound = 2.3;
constexpr double kMargin = SweepClearances::kReach + 1.0;  ///< spacings around the motion

constexpr double kMostPoints = 2.5e8;
constexpr double kUsualPoints = 6e7;
/// Metres: a body without size has no lattice of its own.
constexpr double kLeastSpacing = 1e-12;

constexpr double kUsualExcess = 0.07;
constexpr double kUsualCells = 15e3;       ///< that the surface crosses, about: fine enough to look at
constexpr double kMostUsualCells = 110e3;  ///< about a million triangles
constexpr double kFirstSpacings = 20.0;    ///< of the diagonal of the body
/// A surface is kept when the spacing wanted is no less than this share of its own.
constexpr double kFineEnough = 0.85;
/// Coarse surfaces say little of how fine the last one will be.
constexpr double kMostRefinement = 4.0;
/// Shares of the remaining progress for the first, coarse surface and for each later one.
constexpr double kShareOfFirst = 0.2;
constexpr double kShareOfFine = 0.8;
/// Spacings: points that are nearer to what is covered do not count as outside, in the mean (measured).
constexpr double kCountedOffset = 0.12;

/// Holds the body during the motion.
Box3 boxOf(const TriangleMesh& body, const std::vector<Pose>& path) {
  const MotionBound speed(body);
  Box3 box = boundingBox(body, path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    Box3 ends = boundingBox(body, path[i - 1]).merged(boundingBox(body, path[i]));
    // A point is at most half of its way from one of the ends; straight translations stay between them.
    const bool turns = path[i - 1].orientation.coeffs() != path[i].orientation.coeffs();
    const double aside = turns ? 0.5 * speed(path[i - 1], path[i]) : 0.0;
    ends.min().array() -= aside;
    ends.max().array() += aside;
    box.extend(ends);
  }
  return box;
}

double pointsIn(const Box3& box, double spacing) {
  return ((box.sizes().array() + 2.0 * kMargin * spacing) / spacing + 2.0).prod();
}

/// The least spacing with no more than so many points.
double leastSpacing(const Box3& box, double points) {
  double spacing = std::cbrt(std::max(box.volume(), 1e-300) / points);
  spacing = std::max({spacing, box.diagonal().norm() / 1e5, kLeastSpacing});
  while (pointsIn(box, spacing) > points) spacing *= 1.05;
  return spacing;
}

/// The least spacing for which coordinates of 32 bits, as files have them, are within what clearances leave for
/// rounding.
double spacingOfSinglePrecision(const Box3& box) {
  constexpr double kRounding = 0.0025;  // spacings
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::numeric_limits<float>::epsilon() * farthest / kRounding;
}

Diagnostic refusal(ErrorKind kind, const Message& reason, const Message& advice) {
  return {kind, "", "", reason, advice};
}

Diagnostic interruption() {
  return refusal(ErrorKind::Interrupted, GLISSADE_TEXT("the swept volume was not finished"),
                 GLISSADE_TEXT("Start it again."));
}

Diagnostic nothingMoves() {
  return refusal(ErrorKind::Usage, GLISSADE_TEXT("there is no moving part"),
                 GLISSADE_TEXT("Give a body with triangles and a path."));
}

/// The volume by which the surface is larger than what is covered, as a share of that.
double excessOf(const SweptVolume& sweep, const EnclosingValues& enclosing, double spacing) {
  const auto inside = static_cast<double>(std::count(enclosing.outside.begin(), enclosing.outside.end(), false));
  const double covered = inside * std::pow(spacing, 3.0) - kCountedOffset * spacing * areaOf(sweep.surface_W);
  if (covered <= 0.0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, sweep.volume / covered - 1.0);
}

/// Tells the progress of one attempt after the other, of which nobody knows the last: each has a part of what is left.
class Attempts {
 public:
  explicit Attempts(const WorkWatch& watch) : watch_(watch) {}
  WorkWatch next(double share) {
    const double from = done_;
    done_ += share * (1.0 - done_);
    return watch_.part(from, done_);
  }

 private:
  const WorkWatch& watch_;
  double done_ = 0.0;
};

/// With this spacing; the bound is what it comes to.
Result<SweptVolume> sweepWithSpacing(const TriangleMesh& body, const std::vector<Pose>& path, Box3 box, double spacing,
                                     const WorkWatch& watch) {
  if (const double least = spacingOfSinglePrecision(box); spacing < least) {
    return refusal(
        ErrorKind::LimitReached,
        GLISSADE_TEXT("the bound of the swept volume is finer than 32-bit coordinates are so far from the origin"),
        {GLISSADE_TEXT("Give at least %1 mm."), {1e3 * kBound * least}});
  }
  if (pointsIn(box, spacing) > kMostPoints) {
    return refusal(ErrorKind::LimitReached, GLISSADE_TEXT("the bound of the swept volume needs more than 4 GiB"),
                   {GLISSADE_TEXT("Give at least %1 mm."), {1e3 * kBound * leastSpacing(box, kMostPoints)}});
  }
  box.min().array() -= kMargin * spacing;
  box.max().array() += kMargin * spacing;
  const Lattice lattice = Lattice::over(box, spacing);
  const SweepClearances clearances = sweepClearances(lattice, body, path, watch.part(0.0, 0.8));
  if (watch.stop.stopRequested()) return interruption();
  const EnclosingValues enclosing = enclosingValues(lattice, clearances, watch.part(0.8, 1.0));
  if (watch.stop.stopRequested()) return interruption();
  SweptVolume result;
  result.surface_W = levelSurface(lattice, enclosing.values, 0.0F);
  result.bound = farthestFromBody(result.surface_W, lattice, clearances);
  result.volume = signedVolume(result.surface_W);
  result.excess = excessOf(result, enclosing, spacing);
  return result;
}

}  // namespace

Result<SweptVolume> sweptVolume(const TriangleMesh& body, const std::vector<Pose>& path, double bound,
                                const WorkWatch& watch) {
  if (body.empty() || path.empty()) return nothingMoves();
  if (!(bound > 0.0) || !std::isfinite(bound)) {
    return refusal(ErrorKind::Usage, GLISSADE_TEXT("the bound of the swept volume is not above 0"),
                   GLISSADE_TEXT("Give a length as 0.5mm."));
  }
  const Box3 box = boxOf(body, path);
  double spacing = bound / kBound;
  Attempts attempts(watch);
  auto sweep = sweepWithSpacing(body, path, box, spacing, attempts.next(kShareOfFine));
  while (sweep && sweep->bound > bound) {
    spacing *= std::clamp(0.98 * bound / sweep->bound, 0.5, 0.98);
    sweep = sweepWithSpacing(body, path, box, spacing, attempts.next(kShareOfFine));
  }
  return sweep;
}

Result<SweptVolume> usualSweptVolume(const TriangleMesh& body, const std::vector<Pose>& path, const WorkWatch& watch) {
  if (body.empty() || path.empty()) return nothingMoves();
  const Box3 box = boxOf(body, path);
  const double least = std::max(leastSpacing(box, kUsualPoints), spacingOfSinglePrecision(box));
  double spacing = std::max(least, boundingBox(body).diagonal().norm() / kFirstSpacings);
  Attempts attempts(watch);
  for (double share = kShareOfFirst;; share = kShareOfFine) {
    auto sweep = sweepWithSpacing(body, path, box, spacing, attempts.next(share));
    if (!sweep) return sweep;
    const double area = areaOf(sweep->surface_W);
    double wanted = std::min(std::sqrt(area / kUsualCells), spacing * kUsualExcess / sweep->excess);
    wanted = std::max({wanted, std::sqrt(area / kMostUsualCells), least});
    if (wanted >= kFineEnough * spacing) return sweep;
    spacing = std::max(wanted, spacing / kMostRefinement);
  }
}

}  // namespace glissade
