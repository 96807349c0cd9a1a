#include "engine/collision/kernel/kernel_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/collision/kernel/motion_search.h"

namespace glissade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr BoxPair kRoots{};

void addTriangles(const TriangleMesh& mesh, int body, std::vector<OwnedTriangle>& triangles) {
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, body});
  }
}

std::vector<OwnedTriangle> trianglesOf(const std::vector<RigidBody>& obstacles) {
  std::vector<OwnedTriangle> triangles;
  for (std::size_t body = 0; body < obstacles.size(); ++body) {
    addTriangles(transformed(*obstacles[body].mesh, obstacles[body].X_WB), static_cast<int>(body), triangles);
  }
  return triangles;
}

std::vector<OwnedTriangle> trianglesOf(const TriangleMesh& object) {
  std::vector<OwnedTriangle> triangles;
  addTriangles(object, 0, triangles);
  return triangles;
}

/// A float bound that rules nothing out that the double would keep.
float roundedUp(double value) {
  return value < std::numeric_limits<float>::max() ? static_cast<float>(value) * 1.000001F + 1e-37F
                                                   : std::numeric_limits<float>::infinity();
}

}  // namespace

KernelGeometry::KernelGeometry(const std::vector<RigidBody>& obstacleBodies, const TriangleMesh& objectMesh)
    : obstacles(trianglesOf(obstacleBodies)), object(trianglesOf(objectMesh)) {}

KernelQuery::KernelQuery(std::shared_ptr<const KernelGeometry> geometry, const lanes::LaneFunctions& functions)
    : geometry_(std::move(geometry)),
      functions_(functions),
      traversal_(geometry_->obstacles, geometry_->object, functions) {}

bool KernelQuery::moveTo(const Pose& X_WB, double bound) {
  if (geometry_->obstacles.empty() || geometry_->object.empty()) return false;
  traversal_.placed.moveTo(X_WB);
  return traversal_.placed.sphereGap() <= bound;
}

/// Two leaves meet in an obstacle below `bodiesBelow`: which is the lowest.
bool KernelQuery::leavesMeet(const BoxPair& leaves, int bodiesBelow, int& body) {
  const std::uint32_t firstObstacle = traversal_.obstacles.leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  bool found = false;
  for (unsigned mask = traversal_.mayMeet(leaves); mask != 0; mask &= mask - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(mask));
    const OwnedTriangle& obstacle = traversal_.obstacles.triangles[firstObstacle + bit % lanes::kLeafTriangles];
    if (obstacle.body >= bodiesBelow) continue;
    if (!trianglesMeet(obstacle.corners, traversal_.placed.triangle(firstObject + bit / lanes::kLeafTriangles))) {
      continue;
    }
    body = bodiesBelow = obstacle.body;
    found = true;
  }
  return found;
}

bool KernelQuery::touches(const Pose& X_WB) {
  if (!moveTo(X_WB, 0.0)) return false;
  int body = 0;
  stack_.assign(1, kRoots);
  while (!stack_.empty()) {
    const BoxPair pair = stack_.back();
    stack_.pop_back();
    if (traversal_.bothLeaves(pair)) {
      if (leavesMeet(pair, std::numeric_limits<int>::max(), body)) return true;
      continue;
    }
    const auto opened = traversal_.open(pair);
    for (unsigned mask = traversal_.within(opened, 0.0F); mask != 0; mask &= mask - 1) {
      stack_.push_back(opened[static_cast<unsigned>(__builtin_ctz(mask))]);
    }
  }
  return false;
}

std::optional<int> KernelQuery::touchingBody(const Pose& X_WB) {
  if (!moveTo(X_WB, 0.0)) return std::nullopt;
  int lowest = std::numeric_limits<int>::max();
  stack_.assign(1, kRoots);
  while (!stack_.empty()) {
    const BoxPair pair = stack_.back();
    stack_.pop_back();
    if (traversal_.obstacles.lowestBody[pair.obstacle] >= lowest) continue;
    if (traversal_.bothLeaves(pair)) {
      leavesMeet(pair, lowest, lowest);
      continue;
    }
    const auto opened = traversal_.open(pair);
    for (unsigned mask = traversal_.within(opened, 0.0F); mask != 0; mask &= mask - 1) {
      stack_.push_back(opened[static_cast<unsigned>(__builtin_ctz(mask))]);
    }
  }
  return lowest < std::numeric_limits<int>::max() ? std::optional<int>(lowest) : std::nullopt;
}

void KernelQuery::consider(std::uint32_t obstacle, std::uint32_t object, Best& best) {
  const TriangleDistance distance =
      triangleDistance(traversal_.obstacleTriangle(obstacle), traversal_.placed.triangle(object));
  const bool lower = std::pair(obstacle, object) < std::pair(best.obstacle, best.object);
  if (distance.squared < best.distance.squared || (distance.squared == best.distance.squared && lower)) {
    best = {distance, obstacle, object};
  }
}

void KernelQuery::nearestInLeaves(const BoxPair& leaves, Best& best) {
  constexpr std::size_t kPairs = lanes::kLeafTriangles * lanes::kLeafTriangles;
  alignas(32) std::array<float, kPairs> squared;
  traversal_.triangleDistances(leaves, squared.data());
  const std::uint32_t firstObstacle = traversal_.obstacles.leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  while (true) {
    const auto least = std::min_element(squared.begin(), squared.end());
    if (*least == std::numeric_limits<float>::infinity() || *least > roundedUp(best.distance.squared)) return;
    const auto at = static_cast<std::uint32_t>(least - squared.begin());
    consider(firstObstacle + at % lanes::kLeafTriangles, firstObject + at / lanes::kLeafTriangles, best);
    *least = std::numeric_limits<float>::infinity();
  }
}

/// The opened pairs that may still matter, the nearest on top.
void KernelQuery::push(const PairTraversal::Opened& opened, double squaredBound) {
  alignas(32) std::array<float, lanes::kWidth> squared;
  traversal_.distances(opened, squared.data());
  const float bound = roundedUp(squaredBound);
  const std::size_t begin = candidates_.size();
  for (unsigned lane = 0; lane < opened.lanes; ++lane) {
    if (squared[lane] > bound) continue;
    const Candidate candidate{opened[lane], squared[lane]};
    std::size_t at = candidates_.size();
    candidates_.push_back(candidate);
    for (; at > begin && candidates_[at - 1].squared < candidate.squared; --at) candidates_[at] = candidates_[at - 1];
    candidates_[at] = candidate;
  }
}

/// Improves `best` to the nearest of all pairs, or to some pair at `stopAt` (squared) or nearer.
void KernelQuery::search(Best& best, double stopAt) {
  candidates_.assign(1, {kRoots, 0.0F});
  while (!candidates_.empty() && !(best.distance.squared <= stopAt)) {
    const Candidate candidate = candidates_.back();
    candidates_.pop_back();
    if (candidate.squared > roundedUp(best.distance.squared)) continue;
    if (traversal_.bothLeaves(candidate.pair)) {
      nearestInLeaves(candidate.pair, best);
    } else {
      push(traversal_.open(candidate.pair), best.distance.squared);
    }
  }
}

NearestObstacle KernelQuery::nearest(const Pose& X_WB, double enough) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  NearestObstacle result;
  result.distance = enough;
  if (!moveTo(X_WB, enough)) return result;
  Best best{{enough * enough, {}, {}}, kNone, kNone};
  if (last_) consider(last_->first, last_->second, best);
  search(best, -1.0);
  if (best.obstacle == kNone) return result;
  last_ = {best.obstacle, best.object};
  // Surfaces that do not touch are apart, by however little.
  result.distance = std::max(std::sqrt(best.distance.squared), std::numeric_limits<double>::min());
  result.body = traversal_.obstacles.triangles[best.obstacle].body;
  result.p_WPo = best.distance.onA;
  result.p_WPn = best.distance.onB;
  return result;
}

bool KernelQuery::isWithin(const Pose& X_WB, double bound) {
  if (bound < 0.0 || !moveTo(X_WB, bound)) return false;
  // Equal distances count: nothing at the bound may be ruled out.
  const double squared = bound * bound;
  Best best{{std::nextafter(squared, kInfinity), {}, {}}, 0, 0};
  if (last_) consider(last_->first, last_->second, best);
  search(best, squared);
  return best.distance.squared <= squared;
}

std::optional<MotionCheck> KernelQuery::checkMotion(const Pose& from, const Pose& to, double required,
                                                    const StopToken& stop) {
  if (geometry_->obstacles.empty() || geometry_->object.empty())
    return MotionCheck{CertificateStatus::Certified, 1.0, 1.0, 0};
  return MotionSearch(traversal_, from, to, required).run(stop);
}

}  // namespace glissade
