#include "engine/collision/kernel/motion_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// As in the certificate: less than this share above the requirement counts as below it.
constexpr double kSlimmestMargin = 1e-3;
/// The first violation is found to within this way, as a share of the object's size.
constexpr double kLocated = 1e-3;
constexpr std::uint64_t kMostConfigurations = 200'000;
/// Boxes this much smaller than the way they go are not opened: halving time says more.
constexpr float kWorthOpening = 1.0F;
/// Triangles this much larger than the way they go are worth a plane between them.
constexpr double kWorthAPlane = 4.0;

/// The sense of a turn by half a circle is a matter of rounding.
constexpr double kNearlyHalfATurn = 3.1;

float above(double value) { return static_cast<float>(value) * 1.000001F + 1e-37F; }

}  // namespace

MotionSearch::MotionSearch(PairTraversal& traversal, const Pose& from, const Pose& to, double required)
    : traversal_(traversal),
      from_(from),
      to_(to),
      velocity_(from, to),
      speed_(velocity_.translation_W.norm()),
      middle_(from),
      required_(required) {}

double MotionSearch::way(BoxTree::Box box, double half) const {
  const lanes::BoxLanes& node = traversal_.object.nodes[BoxTree::nodeAround(box)];
  const std::size_t lane = BoxTree::laneOf(box);
  const Vector3 centre =
      traversal_.object.centre + Vector3(node.centre[0][lane], node.centre[1][lane], node.centre[2][lane]);
  const double arm = velocity_.axis_B.cross(centre).norm() + traversal_.object.radius[box];
  return half * (speed_ + velocity_.rotation * arm) * (1.0 + 1e-12);
}

MotionCheck MotionSearch::run(const StopToken& stop) {
  MotionCheck result;
  const double located = std::max(required_, kLocated * traversal_.object.reach);
  std::vector<Interval> todo{{0.0, 1.0, {BoxPair{}}}, {0.0, 0.0, {BoxPair{}}}};
  while (!todo.empty()) {
    if (stop.stopRequested() || ++result.configurations > kMostConfigurations) return result;
    Interval interval = std::move(todo.back());
    todo.pop_back();
    const double middle = interval.middle();
    const double longest = way(0, interval.half());
    middle_ = interpolate(from_, to_, middle);
    traversal_.placed.moveTo(middle_);
    const Finding finding = examine(interval);
    if (finding == Finding::Clear) {
      result.certified = interval.end;
      continue;
    }
    const bool violated = finding == Finding::Violation || longest <= kSlimmestMargin * required_;
    if (violated) {
      result.status = CertificateStatus::Violated;
      result.at = middle;
      todo.clear();  // what is later does not matter any more
    }
    const bool known = result.status == CertificateStatus::Violated;
    if (known && (longest <= located || interval.half() <= 0.0)) return result;
    if (!violated) todo.push_back({middle, interval.end, interval.pairs});
    todo.push_back({interval.begin, middle, std::move(interval.pairs)});
  }
  if (result.status == CertificateStatus::Undecided) result.status = CertificateStatus::Certified;
  return result;
}

MotionSearch::Finding MotionSearch::examine(Interval& interval) {
  const double half = interval.half();
  std::vector<BoxPair>& pairs = interval.pairs;
  if (traversal_.placed.sphereGap() > required_ + way(0, half)) pairs.clear();
  while (!pairs.empty()) {
    const BoxPair pair = pairs.back();
    const double mayGo = way(pair.object, half);
    const float size = std::max(traversal_.obstacles.radius[pair.obstacle], traversal_.object.radius[pair.object]);
    if (size < kWorthOpening * static_cast<float>(mayGo)) return Finding::Doubtful;
    if (traversal_.bothLeaves(pair)) {
      const Finding finding = examineLeaves(pair, half, mayGo);
      if (finding != Finding::Clear) return finding;
      pairs.pop_back();
      continue;
    }
    pairs.pop_back();
    const auto opened = traversal_.open(pair);
    for (unsigned mask = traversal_.within(opened, above(required_ + mayGo)); mask != 0; mask &= mask - 1) {
      pairs.push_back(opened[static_cast<unsigned>(__builtin_ctz(mask))]);
    }
  }
  return Finding::Clear;
}

bool MotionSearch::meets(const BoxPair& leaves) {
  const std::uint32_t firstObstacle = traversal_.obstacles.leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  for (unsigned mask = traversal_.mayMeet(leaves); mask != 0; mask &= mask - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(mask));
    if (trianglesMeet(traversal_.obstacleTriangle(firstObstacle + bit % lanes::kLeafTriangles),
                      traversal_.placed.triangle(firstObject + bit / lanes::kLeafTriangles))) {
      return true;
    }
  }
  return false;
}

bool MotionSearch::keptApart(const TrianglePair& pair, const TriangleDistance& distance, double half) const {
  if (distance.squared <= 0.0 || velocity_.rotation > kNearlyHalfATurn) return false;
  const Vector3 normal = (distance.onB - distance.onA).normalized();
  const Vector3 spin_W = velocity_.rotation * (middle_.orientation * velocity_.axis_B);
  const double turned = velocity_.rotation * half;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3& corner : traversal_.placed.triangle(pair.object)) {
    const Vector3 arm = corner - middle_.position;
    const double towards = std::abs(normal.dot(velocity_.translation_W + spin_W.cross(arm)));
    // What a circle leaves its tangent by.
    const double bend = 0.5 * turned * turned * arm.norm();
    lowest = std::min(lowest, normal.dot(corner - distance.onA) - (half * towards + bend) * (1.0 + 1e-9));
  }
  double highest = -std::numeric_limits<double>::infinity();
  for (const Vector3& corner : traversal_.obstacleTriangle(pair.obstacle)) {
    highest = std::max(highest, normal.dot(corner - distance.onA));
  }
  return lowest - highest > required_;
}

MotionSearch::Finding MotionSearch::examineLeaves(const BoxPair& leaves, double half, double way) {
  if (meets(leaves)) return Finding::Violation;
  const auto distances = traversal_.triangleDistances(leaves);
  const double reach = required_ + way;
  const float bound = above(reach * reach);
  const double size = std::max(traversal_.obstacles.radius[leaves.obstacle], traversal_.object.radius[leaves.object]);
  const bool planes = size > kWorthAPlane * way;
  for (std::size_t i = 0; i < distances.squared.size(); ++i) {
    if (distances.squared[i] > bound) continue;
    const TrianglePair pair = distances[i];
    const TriangleDistance distance =
        triangleDistance(traversal_.obstacleTriangle(pair.obstacle), traversal_.placed.triangle(pair.object));
    if (distance.squared < required_ * required_) return Finding::Violation;
    if (distance.squared <= reach * reach && (!planes || !keptApart(pair, distance, half))) return Finding::Doubtful;
  }
  return Finding::Clear;
}

}  // namespace glissade
