#include "engine/sweep/swept_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <thread>

#include "engine/base/number_text.h"
#include "engine/base/thread_team.h"
#include "engine/collision/motion_bound.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/sweep/level_surface.h"
#include "engine/sweep/surface_distances.h"

namespace glissade {
namespace {

// All lengths in spacings of the world's lattice. Distances change by at most the distance of two points. Between the
// corners of a cube (or of a tetrahedron in it) an interpolated value is off by at most half the cube's diagonal.
constexpr double kTimeError = 0.5;
constexpr double kWorldError = 0.5 * std::numbers::sqrt3;
constexpr double kBodySpacing = 0.5;
constexpr double kBodyError = kBodySpacing * kWorldError;
/// Of numbers in single precision, and of the vertices that levelSurface() moves.
constexpr double kRounding = 0.005;
/// The body is never where interpolated distances are above this.
constexpr double kLevel = kTimeError + kWorldError + kBodyError + kRounding;
/// The distance from a point of the surface to the body, at the time when the body is nearest, is at most this.
constexpr double kBound = kLevel + kWorldError + kBodyError + kRounding;
/// Larger distances are not told apart: no cell that the surface crosses has a corner that is farther.
constexpr double kReach = kLevel + 2.0 * kWorldError + kBodyError;

constexpr double kMostPoints = 1e9;
constexpr double kUsualPoints = 3e7;
/// Way of the motion times surface of the body's box, in spacings: about a minute of the processor.
constexpr double kUsualWork = 5e7;
/// Metres: a body without size has no lattice of its own.
constexpr double kLeastSpacing = 1e-9;
constexpr std::size_t kMostThreads = 8;

/// A body on its path.
class BodyMotion {
 public:
  BodyMotion(const TriangleMesh& body, const std::vector<Pose>& path) : body_(body), path_(path) {
    const MotionBound speed(body);
    for (std::size_t i = 1; i < path.size(); ++i) ways_.push_back(speed(path[i - 1], path[i]));
  }

  /// The farthest that a point of the body moves, at most.
  double way() const { return std::accumulate(ways_.begin(), ways_.end(), 0.0); }

  /// Poses so near to each other that no point of the body is ever farther than `step` from where it is at one of them.
  std::vector<Pose> poses(double step) const {
    std::vector<Pose> poses{path_.front()};
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const int pieces = std::max(1, static_cast<int>(std::ceil(ways_[i - 1] / (2.0 * step))));
      for (int k = 1; k <= pieces; ++k) {
        poses.push_back(interpolate(path_[i - 1], path_[i], static_cast<double>(k) / pieces));
      }
    }
    return poses;
  }

  /// Holds the body during the motion.
  Box3 box() const {
    Box3 box = boundingBox(body_, path_.front());
    for (std::size_t i = 1; i < path_.size(); ++i) {
      Box3 ends = boundingBox(body_, path_[i - 1]).merged(boundingBox(body_, path_[i]));
      // A point is at most half of its way from one of the ends; straight translations stay between them.
      const bool turns = path_[i - 1].orientation.coeffs() != path_[i].orientation.coeffs();
      const double aside = turns ? 0.5 * ways_[i - 1] : 0.0;
      ends.min().array() -= aside;
      ends.max().array() += aside;
      box.extend(ends);
    }
    return box;
  }

 private:
  const TriangleMesh& body_;
  const std::vector<Pose>& path_;
  std::vector<double> ways_;  ///< that a point moves at most, by edge of the path
};

double pointsIn(const Box3& box, double spacing) {
  return ((box.sizes().array() + 2.0 * kReach * spacing) / spacing + 2.0).prod();
}

/// The least bound of a motion that needs no more than so many points.
double leastBound(const Box3& box, double points) {
  double spacing = std::cbrt(std::max(box.volume(), 1e-300) / points);
  spacing = std::max({spacing, box.diagonal().norm() / 1e5, kLeastSpacing});
  while (pointsIn(box, spacing) > points) spacing *= 1.05;
  return kBound * spacing;
}

double surfaceOf(const Box3& box) {
  const Vector3 sizes = box.sizes();
  return 2.0 * (sizes.x() * sizes.y() + sizes.y() * sizes.z() + sizes.z() * sizes.x());
}

/// The bound with which the way of the motion times the surface of the body's box, in spacings, is the usual work.
double boundOfUsualWork(const Box3& body, double way) { return kBound * std::cbrt(way * surfaceOf(body) / kUsualWork); }

/// The least bound for which coordinates of 32 bits, as files have them, are within what is added for rounding.
double boundOfSinglePrecision(const Box3& box) {
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return kBound * std::numeric_limits<float>::epsilon() * farthest / (0.5 * kRounding);
}

/// A lattice of the world and, at its points, the least distance from the surface of the body at any of the poses.
class WorldDistances {
 public:
  WorldDistances(const Lattice& lattice, const SurfaceDistances& body)
      : lattice_(lattice), body_(body), values_(lattice.size(), static_cast<float>(kReach * lattice.spacing)) {}

  /// Threads share the work by planes of the lattice, so that each value is written by one of them.
  void lowerAll(const std::vector<Pose>& poses, const StopToken& stop) {
    ThreadTeam team(std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads) - 1);
    const int planes = lattice_.counts[0];
    const int slabs = std::min(planes, 4 * static_cast<int>(team.threads()));
    team.run(static_cast<std::size_t>(slabs), [&](std::size_t slab) {
      const int first = static_cast<int>(slab) * planes / slabs;
      const int last = (static_cast<int>(slab) + 1) * planes / slabs - 1;
      for (const Pose& pose : poses) {
        if (stop.stopRequested()) return;
        lower(pose, first, last);
      }
    });
  }

  /// Points that are not connected with the rim by points above the level get 0: they are enclosed.
  void fillInside(float level) {
    std::vector<std::size_t> outside{0};
    std::vector<bool> seen(values_.size(), false);
    seen[0] = true;
    while (!outside.empty()) {
      const std::size_t point = outside.back();
      outside.pop_back();
      forEachNeighbour(point, [&](std::size_t next) {
        if (seen[next] || values_[next] <= level) return;
        seen[next] = true;
        outside.push_back(next);
      });
    }
    for (std::size_t point = 0; point < values_.size(); ++point) {
      if (!seen[point] && values_[point] > level) values_[point] = 0.0F;
    }
  }

  const std::vector<float>& values() const { return values_; }

 private:
  void lower(const Pose& pose, int firstPlane, int lastPlane) {
    const Eigen::Matrix3d R_WB = pose.orientation.toRotationMatrix();
    const Vector3 half = Vector3::Constant(0.5 * body_.blockSize());
    const Vector3 half_W = R_WB.cwiseAbs() * half + Vector3::Constant(kMargin * lattice_.spacing);
    for (const SurfaceDistances::Block& block : body_.blocks()) {
      const Vector3 middle = R_WB * (block.least_B + half) + pose.position;
      LatticeRange range = rangeWithin(lattice_, Box3(middle - half_W, middle + half_W));
      range.first[0] = std::max(range.first[0], firstPlane);
      range.last[0] = std::min(range.last[0], lastPlane);
      if (range.first[0] <= range.last[0]) lower(block, R_WB, pose.position, range);
    }
  }

  void lower(const SurfaceDistances::Block& block, const Eigen::Matrix3d& R_WB, const Vector3& position,
             const LatticeRange& range) {
    // Along z the place in the block changes by a constant.
    const double perCell = 1.0 / body_.spacing();
    const Vector3 step = R_WB.transpose().col(2) * (lattice_.spacing * perCell);
    constexpr double kEnd = SurfaceDistances::kCells;
    for (int x = range.first[0]; x <= range.last[0]; ++x) {
      for (int y = range.first[1]; y <= range.last[1]; ++y) {
        Vector3 at = (R_WB.transpose() * (lattice_.point(x, y, range.first[2]) - position) - block.least_B) * perCell;
        float* value = &values_[lattice_.at(x, y, range.first[2])];
        for (int z = range.first[2]; z <= range.last[2]; ++z, ++value, at += step) {
          if (at.minCoeff() < -kMargin || at.maxCoeff() > kEnd + kMargin) continue;
          *value = std::min(*value, SurfaceDistances::interpolated(block, at));
        }
      }
    }
  }

  template <class Visit>
  void forEachNeighbour(std::size_t point, const Visit& visit) const {
    const auto ny = static_cast<std::size_t>(lattice_.counts[1]);
    const auto nz = static_cast<std::size_t>(lattice_.counts[2]);
    const std::array<std::size_t, 3> at{point / (ny * nz), point / nz % ny, point % nz};
    const std::array<std::size_t, 3> strides{ny * nz, nz, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (at[axis] > 0) visit(point - strides[axis]);
      if (at[axis] + 1 < static_cast<std::size_t>(lattice_.counts[axis])) visit(point + strides[axis]);
    }
  }

  /// In cells: rounding must not lose a point between two blocks.
  static constexpr double kMargin = 1e-6;

  const Lattice& lattice_;
  const SurfaceDistances& body_;
  std::vector<float> values_;
};

Diagnostic refusal(ErrorKind kind, const std::string& reason, const std::string& advice) {
  return {kind, "", "", reason, advice};
}

}  // namespace

double usualSweepBound(const TriangleMesh& body, const std::vector<Pose>& path) {
  if (body.empty() || path.empty()) return 0.0;
  const Box3 box = boundingBox(body);
  const BodyMotion motion(body, path);
  return std::max({box.diagonal().norm() / 200.0, leastBound(motion.box(), kUsualPoints),
                   leastBound(box, 2.0 * kUsualPoints) / kBodySpacing, boundOfUsualWork(box, motion.way())});
}

Result<SweptVolume> sweptVolume(const TriangleMesh& body, const std::vector<Pose>& path, double bound,
                                const StopToken& stop) {
  if (body.empty() || path.empty()) {
    return refusal(ErrorKind::Usage, "there is nothing that moves", "Give a body with triangles and a path.");
  }
  if (!(bound > 0.0) || !std::isfinite(bound)) {
    return refusal(ErrorKind::Usage, "the bound of the swept volume is not above 0", "Give a length as 0.5mm.");
  }
  const double spacing = bound / kBound;
  const BodyMotion motion(body, path);
  Box3 box = motion.box();
  if (const double least = boundOfSinglePrecision(box); bound < least) {
    return refusal(ErrorKind::LimitReached,
                   "the bound of the swept volume is finer than 32-bit coordinates are so far from the origin",
                   "Give at least " + toText(1e3 * least) + " mm.");
  }
  const double bodyPoints = pointsIn(boundingBox(body), kBodySpacing * spacing);
  if (std::max(pointsIn(box, spacing), bodyPoints) > kMostPoints) {
    const double least =
        std::max(leastBound(box, kMostPoints), leastBound(boundingBox(body), kMostPoints) / kBodySpacing);
    return refusal(ErrorKind::LimitReached, "the bound of the swept volume needs more than 4 GiB",
                   "Give at least " + toText(1e3 * least) + " mm.");
  }
  box.min().array() -= (kReach + 1.0) * spacing;
  box.max().array() += (kReach + 1.0) * spacing;
  const Lattice lattice = Lattice::over(box, spacing);
  const SurfaceDistances distances(body, kBodySpacing * spacing, kReach * spacing, stop);
  WorldDistances world(lattice, distances);
  world.lowerAll(motion.poses(kTimeError * spacing), stop);
  if (stop.stopRequested())
    return refusal(ErrorKind::Interrupted, "the swept volume was not finished", "Start it again.");
  const auto level = static_cast<float>(kLevel * spacing);
  world.fillInside(level);
  SweptVolume result;
  result.surface_W = levelSurface(lattice, world.values(), level);
  result.bound = bound;
  result.volume = signedVolume(result.surface_W);
  return result;
}

}  // namespace glissade
