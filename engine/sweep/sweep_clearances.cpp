#include "engine/sweep/sweep_clearances.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

#include "engine/base/thread_team.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/pose.h"
#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_tree.h"
#include "engine/sweep/helper_threads.h"

namespace glissade {
namespace {

/// A piece of a straight motion, so short that a point of the world moves nearly straight as the body sees it.
struct MotionPiece {
  Pose from;              ///< X_WB at its beginning
  Pose to;                ///< X_WB at its end
  double rotation = 0.0;  ///< radians
  double way = 0.0;       ///< of the body's origin, metres

  /// How far a point of the world, seen from the body, is from the straight line between where it is at the beginning
  /// and at the end, at most. `distance`: of the point from the body's origin, at most, at both ends; metres.
  ///
  /// With p_B(t) = R(t)^T (p - x(t)), rotation θ and way w the second derivative is at most θ² |p - x| + 2 θ w, and a
  /// curve is off its chord by at most an eighth of that.
  double deviation(double distance) const { return (rotation * distance + 2.0 * way) * rotation / 8.0; }
};

MotionPiece pieceBetween(const Pose& from, const Pose& to) {
  return {from, to, angleBetween(from.orientation, to.orientation), (to.position - from.position).norm()};
}

/// The straight motions between consecutive poses in pieces that deviate by at most `deviation` for points at
/// `distance` from the body's origin, and in which such a point moves by at most `longest` as the body sees it. Metres.
/// A path of one pose is a piece without motion.
std::vector<MotionPiece> piecesOf(const std::vector<Pose>& path, double distance, double deviation, double longest) {
  if (path.size() == 1) return {pieceBetween(path.front(), path.front())};
  std::vector<MotionPiece> pieces;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const MotionPiece whole = pieceBetween(path[i - 1], path[i]);
    const double forDeviation = std::sqrt(whole.deviation(distance) / deviation);
    const double forLength = (whole.way + whole.rotation * distance) / longest;
    const int count = std::max(1, static_cast<int>(std::ceil(std::max(forDeviation, forLength))));
    Pose from = path[i - 1];
    for (int k = 1; k <= count; ++k) {
      const Pose to = interpolate(path[i - 1], path[i], static_cast<double>(k) / count);
      pieces.push_back(pieceBetween(from, to));
      from = to;
    }
  }
  return pieces;
}

// In spacings of the lattice.
constexpr double kDeviation = 0.03;    ///< of a piece of the motion from a straight one
constexpr double kLongestPiece = 8.0;  ///< as the body sees it: boxes around longer segments rule out little
constexpr double kEnough = 0.025;      ///< a smaller clearance is taken as 0
constexpr double kRounding = 0.005;    ///< of numbers in single precision, here and in files
static_assert(SweepClearances::kSlack >= kEnough + 2.0 * kDeviation + kRounding);

constexpr int kPointsOfAJob = 32;      ///< of a block that a thread takes, along each axis
constexpr int kPointsOfALeaf = 2;      ///< of a block that is not divided, along each axis
constexpr double kWider = 1.0 + 1e-9;  ///< what rounding may take from lengths

/// Points of the lattice, from the first one so many along each axis.
struct Block {
  std::array<int, 3> first;
  std::array<int, 3> counts;
};

/// A piece of the motion with the world's poses in the body's frame.
struct SeenPiece {
  MotionPiece piece;
  Eigen::Isometry3d X_BW_from;
  Eigen::Isometry3d X_BW_to;
  Vector3 middle_W;    ///< of the ball around the body, at the beginning
  double swing = 0.0;  ///< that this moves, at most
};

/// A distance is between them.
struct Bounds {
  double least;
  double most;
};

/// A piece in which the body may come near a block.
struct NearPiece {
  double distance;  ///< of the body from the middle of the block, at least
  std::size_t piece;
};

/// The body's surface and its ways.
class MovingBody {
 public:
  MovingBody(const TriangleMesh& mesh, const std::vector<Pose>& path, double spacing) : tree_(mesh), spacing_(spacing) {
    const MeshAudit worth = audit(mesh);
    if (worth.closed()) interior_ = std::make_unique<SolidInterior>(mesh, worth.consistentlyOriented);
    const Vector3 middle_B = tree_.box().center();
    radius_ = 0.5 * tree_.box().diagonal().norm();
    const double farthest = middle_B.norm() + radius_ + SweepClearances::kReach * spacing;
    for (const MotionPiece& piece : piecesOf(path, farthest, kDeviation * spacing, kLongestPiece * spacing)) {
      pieces_.push_back({piece, toIsometry(inverse(piece.from)), toIsometry(inverse(piece.to)), piece.from * middle_B,
                         piece.way + piece.rotation * middle_B.norm()});
    }
  }

  std::size_t pieces() const { return pieces_.size(); }

  /// Quick: the body is farther from p than this during all of the piece.
  bool isFarther(std::size_t index, const Vector3& p_W, double distance) const {
    const SeenPiece& seen = pieces_[index];
    const double most = (radius_ + seen.swing + distance) * kWider;
    return (p_W - seen.middle_W).squaredNorm() > most * most;
  }

  /// The distance of the body's surface from p, at its nearest during the piece; from `limit` on both are at least
  /// that.
  Bounds clearance(std::size_t index, const Vector3& p_W, double limit) const {
    const SeenPiece& seen = pieces_[index];
    const Vector3 from = seen.X_BW_from * p_W;
    const Vector3 to = seen.X_BW_to * p_W;
    const double deviation = seen.piece.deviation(std::max(from.norm(), to.norm()));
    const double error = deviation + kRounding * spacing_;
    const double distance = tree_.distanceToSegment(from, to, limit + error, kEnough * spacing_);
    return {distance - error, distance + error};
  }

  /// The body is a solid, and p is inside it at the beginning of the piece.
  bool contains(std::size_t index, const Vector3& p_W) const {
    return interior_ && interior_->contains(pieces_[index].X_BW_from * p_W);
  }

 private:
  TriangleTree tree_;
  std::unique_ptr<SolidInterior> interior_;  ///< of a closed mesh
  std::vector<SeenPiece> pieces_;
  double spacing_;
  double radius_ = 0.0;  ///< of a ball around the body
};

/// The values of one block and of all blocks within it.
class BlockClearances {
 public:
  BlockClearances(const Lattice& lattice, const MovingBody& body, const StopToken& stop, std::vector<float>& values)
      : lattice_(lattice),
        body_(body),
        stop_(stop),
        reach_(SweepClearances::kReach * lattice.spacing),
        values_(values) {}

  void lower(const Block& block) const {
    std::vector<NearPiece> near;
    const Vector3 middle = middleOf(block);
    const double far = radiusOf(block) + reach_;
    for (std::size_t piece = 0; piece < body_.pieces(); ++piece) {
      if (!body_.isFarther(piece, middle, far)) near.push_back({0.0, piece});
    }
    lower(block, near, 0.0);
  }

 private:
  Vector3 middleOf(const Block& block) const {
    const Vector3 first = lattice_.point(block.first[0], block.first[1], block.first[2]);
    return first + 0.5 * lattice_.spacing * Vector3(block.counts[0] - 1, block.counts[1] - 1, block.counts[2] - 1);
  }
  double radiusOf(const Block& block) const {
    return 0.5 * lattice_.spacing * kWider *
           Vector3(block.counts[0] - 1, block.counts[1] - 1, block.counts[2] - 1).norm();
  }

  /// `candidates`: the nearest first, with distances from a point that is `aside` from the block's middle.
  void lower(const Block& block, const std::vector<NearPiece>& candidates, double aside) const {
    const Vector3 middle = middleOf(block);
    const double radius = radiusOf(block);
    std::vector<NearPiece> near;
    double limit = radius + reach_;
    for (const NearPiece& candidate : candidates) {
      if (stop_.stopRequested()) return;
      if (candidate.distance - aside >= limit) break;
      const Bounds distance = body_.clearance(candidate.piece, middle, limit);
      if (distance.least > radius && body_.contains(candidate.piece, middle)) {
        forEachPoint(block, [&](int x, int y, int z) { values_[lattice_.at(x, y, z)] = 0.0F; });
        return;
      }
      if (distance.least >= limit) continue;
      near.push_back({distance.least, candidate.piece});
      // In farther pieces the body is nearer to no point of the block than in this one.
      limit = std::min(limit, distance.most + 2.0 * radius);
    }
    if (near.empty()) return;
    std::sort(near.begin(), near.end(), [](const NearPiece& a, const NearPiece& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.piece < b.piece;
    });
    while (near.back().distance >= limit) near.pop_back();
    if (*std::max_element(block.counts.begin(), block.counts.end()) > kPointsOfALeaf) {
      forEachOctant(block,
                    [&](const Block& octant) { lower(octant, near, (middleOf(octant) - middle).norm() * kWider); });
      return;
    }
    forEachPoint(block, [&](int x, int y, int z) {
      const Vector3 p = lattice_.point(x, y, z);
      values_[lattice_.at(x, y, z)] = static_cast<float>(valueAt(p, (p - middle).norm() * kWider, near));
    });
  }

  /// The value at a point that is `aside` from the middle of its block.
  double valueAt(const Vector3& p, double aside, const std::vector<NearPiece>& near) const {
    double least = reach_;
    for (const NearPiece& candidate : near) {
      if (candidate.distance - aside >= least) break;
      least = std::min(least, body_.clearance(candidate.piece, p, least).least);
      if (least <= kEnough * lattice_.spacing) return 0.0;
    }
    return least;
  }

  template <class Visit>
  static void forEachPoint(const Block& block, const Visit& visit) {
    for (int x = block.first[0]; x < block.first[0] + block.counts[0]; ++x) {
      for (int y = block.first[1]; y < block.first[1] + block.counts[1]; ++y) {
        for (int z = block.first[2]; z < block.first[2] + block.counts[2]; ++z) visit(x, y, z);
      }
    }
  }

  /// The halves along each axis that has more than one point.
  template <class Visit>
  static void forEachOctant(const Block& block, const Visit& visit) {
    for (unsigned octant = 0; octant < 8; ++octant) {
      Block part = block;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int lower = (block.counts[axis] + 1) / 2;
        const bool isUpper = (octant >> axis & 1U) != 0;
        part.first[axis] += isUpper ? lower : 0;
        part.counts[axis] = isUpper ? block.counts[axis] - lower : lower;
      }
      if (*std::min_element(part.counts.begin(), part.counts.end()) > 0) visit(part);
    }
  }

  const Lattice& lattice_;
  const MovingBody& body_;
  const StopToken& stop_;
  double reach_;  ///< metres
  std::vector<float>& values_;
};

std::vector<Block> jobsOf(const Lattice& lattice) {
  std::vector<Block> jobs;
  Block block{};
  for (block.first[0] = 0; block.first[0] < lattice.counts[0]; block.first[0] += kPointsOfAJob) {
    for (block.first[1] = 0; block.first[1] < lattice.counts[1]; block.first[1] += kPointsOfAJob) {
      for (block.first[2] = 0; block.first[2] < lattice.counts[2]; block.first[2] += kPointsOfAJob) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          block.counts[axis] = std::min(kPointsOfAJob, lattice.counts[axis] - block.first[axis]);
        }
        jobs.push_back(block);
      }
    }
  }
  return jobs;
}

}  // namespace

SweepClearances sweepClearances(const Lattice& lattice, const TriangleMesh& body, const std::vector<Pose>& path,
                                const WorkWatch& watch) {
  SweepClearances result;
  result.values.assign(lattice.size(), static_cast<float>(SweepClearances::kReach * lattice.spacing));
  const MovingBody moving(body, path, lattice.spacing);
  const BlockClearances clearances(lattice, moving, watch.stop, result.values);
  const std::vector<Block> jobs = jobsOf(lattice);
  ThreadTeam team(helperThreads());
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> ended{0};
  team.run(jobs.size(), [&](std::size_t job) {
    clearances.lower(jobs[job]);
    const std::size_t done = ++ended;
    if (std::this_thread::get_id() == caller)
      watch.report(static_cast<double>(done) / static_cast<double>(jobs.size()));
  });
  return result;
}

}  // namespace glissade
