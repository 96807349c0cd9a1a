#include "engine/collision/kernel/motion_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

/// As in the certificate: less than this share above the requirement counts as below it.
constexpr double kSlimmestMargin = 1e-3;
/// The first violation is found to within this way, as a share of the object's size.
constexpr double kLocated = 1e-3;
constexpr std::uint64_t kMostConfigurations = 200'000;
/// Boxes this much smaller than the way they go are not opened: halving time says more.
constexpr float kWorthOpening = 0.5F;

float above(double value) { return static_cast<float>(value) * 1.000001F + 1e-37F; }

}  // namespace

MotionSearch::MotionSearch(PairTraversal& traversal, const Pose& from, const Pose& to, double required)
    : traversal_(traversal), from_(from), to_(to), velocity_(from, to), required_(required) {}

double MotionSearch::way(BoxTree::Box box, double half) const {
  const lanes::BoxLanes& node = traversal_.object.nodes[BoxTree::nodeAround(box)];
  const std::size_t lane = BoxTree::laneOf(box);
  const Vector3 centre =
      traversal_.object.centre + Vector3(node.centre[0][lane], node.centre[1][lane], node.centre[2][lane]);
  const double arm = velocity_.axis_B.cross(centre).norm() + traversal_.object.radius[box];
  return half * (velocity_.translation + velocity_.rotation * arm) * (1.0 + 1e-12);
}

MotionCheck MotionSearch::run(const StopToken& stop) {
  MotionCheck result;
  pairs_.assign(1, BoxPair{});
  std::vector<Interval> todo{{0.0, 1.0, 0, 1}};
  const double located = std::max(required_, kLocated * traversal_.object.reach);
  bool violated = false;
  while (!todo.empty()) {
    if (stop.stopRequested() || ++result.configurations > kMostConfigurations) return result;
    const Interval interval = todo.back();
    todo.pop_back();
    pairs_.resize(interval.lastPair);
    const double middle = 0.5 * (interval.begin + interval.end);
    const double longest = way(0, 0.5 * (interval.end - interval.begin));
    traversal_.placed.moveTo(interpolate(from_, to_, middle));
    const bool clear = examine(interval);
    if (clear && pairs_.size() == interval.lastPair) {
      result.certified = interval.end;
      continue;
    }
    const bool tooShort = longest <= kSlimmestMargin * required_;
    if (!clear || tooShort) {
      violated = true;
      result.at = middle;
      todo.clear();  // what is later does not matter any more
      if (tooShort || 2.0 * longest <= located) break;
      todo.push_back({interval.begin, middle, interval.firstPair, interval.lastPair});
      continue;
    }
    if (violated && 2.0 * longest <= located) break;
    todo.push_back({middle, interval.end, interval.lastPair, pairs_.size()});
    todo.push_back({interval.begin, middle, interval.lastPair, pairs_.size()});
  }
  result.status = violated ? CertificateStatus::Violated : CertificateStatus::Certified;
  return result;
}

bool MotionSearch::examine(const Interval& interval) {
  if (traversal_.placed.sphereGap() > required_ + way(0, 0.5 * (interval.end - interval.begin))) return true;
  const double half = 0.5 * (interval.end - interval.begin);
  stack_.assign(pairs_.begin() + static_cast<std::ptrdiff_t>(interval.firstPair),
                pairs_.begin() + static_cast<std::ptrdiff_t>(interval.lastPair));
  while (!stack_.empty()) {
    const BoxPair pair = stack_.back();
    stack_.pop_back();
    const double mayGo = way(pair.object, half);
    const float size = std::max(traversal_.obstacles.radius[pair.obstacle], traversal_.object.radius[pair.object]);
    if (size < kWorthOpening * static_cast<float>(mayGo)) {
      pairs_.push_back(pair);
    } else if (traversal_.bothLeaves(pair)) {
      if (!examineLeaves(pair, mayGo)) return false;
    } else {
      const auto opened = traversal_.open(pair);
      for (unsigned mask = traversal_.within(opened, above(required_ + mayGo)); mask != 0; mask &= mask - 1) {
        stack_.push_back(opened[static_cast<unsigned>(__builtin_ctz(mask))]);
      }
    }
  }
  return true;
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

bool MotionSearch::examineLeaves(const BoxPair& leaves, double way) {
  if (meets(leaves)) return false;
  alignas(32) std::array<float, lanes::kLeafTriangles * lanes::kLeafTriangles> squared;
  traversal_.triangleDistances(leaves, squared.data());
  const std::uint32_t firstObstacle = traversal_.obstacles.leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  const double reach = required_ + way;
  const float bound = above(reach * reach);
  bool kept = false;
  for (std::uint32_t i = 0; i < squared.size(); ++i) {
    if (squared[i] > bound) continue;
    const double distance = triangleDistance(traversal_.obstacleTriangle(firstObstacle + i % lanes::kLeafTriangles),
                                             traversal_.placed.triangle(firstObject + i / lanes::kLeafTriangles))
                                .squared;
    if (distance < required_ * required_) return false;
    if (distance > reach * reach || kept) continue;
    pairs_.push_back(leaves);
    kept = true;
  }
  return true;
}

}  // namespace glissade
