#include "engine/collision/kernel/kernel_query.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "engine/collision/kernel/box_tree.h"

namespace glissade {
namespace {

/// Hash of a corner. Both signs of zero give the same hash.
std::uint64_t mixed(const Vector3& corner) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = (key ^ std::bit_cast<std::uint64_t>(corner[axis] + 0.0)) * 0x9E3779B97F4A7C15U;
    key ^= key >> 32U;
  }
  return key;
}

/// Hash of a triangle, which does not depend on the order of its corners.
std::uint64_t keyOf(const OwnedTriangle& triangle) {
  return mixed(triangle.corners[0]) + mixed(triangle.corners[1]) + mixed(triangle.corners[2]);
}

bool sameCorners(const Triangle& a, const Triangle& b) {
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  return std::any_of(kOrders.begin(), kOrders.end(), [&](const auto& order) {
    return a[0] == b[order[0]] && a[1] == b[order[1]] && a[2] == b[order[2]];
  });
}

/// Drops each triangle that has the corners of an earlier one of the same body, in whatever order. Files for display
/// have every face twice, once for each side: as sets of points the bodies are the same, with a quarter of the pairs.
void dropRepeated(std::vector<OwnedTriangle>& triangles) {
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  keys.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) keys.emplace_back(keyOf(triangles[i]), i);
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(triangles.size(), false);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const OwnedTriangle& first = triangles[keys[i].second];
    if (repeated[keys[i].second]) continue;
    for (std::size_t k = i + 1; k < keys.size() && keys[k].first == keys[i].first; ++k) {
      const OwnedTriangle& other = triangles[keys[k].second];
      if (other.body == first.body && sameCorners(first.corners, other.corners)) repeated[keys[k].second] = true;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!repeated[i]) triangles[kept++] = triangles[i];
  }
  triangles.resize(kept);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr BoxPair kRoots{};
/// Most triangles in a leaf of the obstacles. Two of the object's triangles and four of the obstacles' fill the lanes;
/// larger leaves do not.
constexpr std::size_t kMostInALeafOfObstacles = 4;
constexpr std::size_t kMostInALeafOfObject = 2;
/// Places of a motion that are tested first, because most colliding motions collide at one of them.
constexpr std::array<double, 3> kTriedFirst{0.0, 1.0, 0.5};

Box3 boxAround(const std::vector<RigidBody>& bodies) {
  Box3 box;
  for (const RigidBody& body : bodies) box.extend(boundingBox(*body.mesh, body.X_WB));
  return box;
}

void addTriangles(const TriangleMesh& mesh, double scale, int body, std::vector<OwnedTriangle>& triangles) {
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({{scale * mesh.vertices[a], scale * mesh.vertices[b], scale * mesh.vertices[c]}, body});
  }
}

std::vector<OwnedTriangle> trianglesOf(const std::vector<RigidBody>& obstacles, double scale) {
  std::vector<OwnedTriangle> triangles;
  for (std::size_t body = 0; body < obstacles.size(); ++body) {
    addTriangles(transformed(*obstacles[body].mesh, obstacles[body].X_WB), scale, static_cast<int>(body), triangles);
  }
  dropRepeated(triangles);
  return triangles;
}

std::vector<OwnedTriangle> trianglesOf(const TriangleMesh& mesh, double scale) {
  std::vector<OwnedTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  addTriangles(mesh, scale, 0, triangles);
  dropRepeated(triangles);
  return triangles;
}

/// A float bound that excludes nothing that the double bound would keep.
float widenedBound(double value) {
  return value < std::numeric_limits<float>::max() ? static_cast<float>(value) * 1.000001F + 1e-37F
                                                   : std::numeric_limits<float>::infinity();
}

}  // namespace

double kernelScale(const Box3& box) {
  const double size = box.isEmpty() ? 0.0 : box.diagonal().norm();
  return size > 0.0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

std::shared_ptr<const BoxTree> kernelObstacle(const TriangleMesh& mesh, double scale, BoxCare care) {
  return std::make_shared<const BoxTree>(trianglesOf(mesh, scale), kMostInALeafOfObstacles, care);
}

std::shared_ptr<const BoxTree> kernelObject(const TriangleMesh& mesh, double scale, BoxCare care) {
  return std::make_shared<const BoxTree>(trianglesOf(mesh, scale), kMostInALeafOfObject, care);
}

KernelGeometry::KernelGeometry(const std::vector<RigidBody>& obstacleBodies, const TriangleMesh& objectMesh)
    : scale(kernelScale(boxAround(obstacleBodies))),
      obstacles(std::make_shared<const BoxTree>(trianglesOf(obstacleBodies, scale), kMostInALeafOfObstacles)),
      object(kernelObject(objectMesh, scale)) {}

KernelGeometry::KernelGeometry(const KernelGeometry& other, const TriangleMesh& objectMesh)
    : scale(other.scale), obstacles(other.obstacles), object(kernelObject(objectMesh, scale)) {}

KernelGeometry::KernelGeometry(double commonScale, std::shared_ptr<const BoxTree> obstacleTree,
                               std::shared_ptr<const BoxTree> objectTree)
    : scale(commonScale), obstacles(std::move(obstacleTree)), object(std::move(objectTree)) {}

KernelQuery::KernelQuery(std::shared_ptr<const KernelGeometry> geometry, const lanes::LaneFunctions& functions)
    : geometry_(std::move(geometry)), traversal_(*geometry_->obstacles, *geometry_->object, functions) {}

void KernelQuery::setObstacles(const BoxTree& obstacles) {
  if (&obstacles == &traversal_.obstacles()) return;
  traversal_.setObstacles(obstacles);
  recentCount_ = 0;
}

bool KernelQuery::moveTo(const Pose& X_WB, double bound) {
  if (traversal_.obstacles().empty() || geometry_->object->empty()) return false;
  traversal_.placed.moveTo(scaled(X_WB));
  return traversal_.placed.sphereGap() <= bound;
}

/// True if two leaves meet in an obstacle below `bodiesBelow`, whose lowest index is stored in `body`.
bool KernelQuery::leavesMeet(const BoxPair& leaves, int bodiesBelow, int& body) {
  const std::uint32_t firstObstacle = traversal_.obstacles().leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  bool found = false;
  for (unsigned mask = traversal_.mayMeet(leaves); mask != 0; mask &= mask - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(mask));
    const OwnedTriangle& obstacle = traversal_.obstacles().triangles[firstObstacle + bit % lanes::kLeafTriangles];
    if (obstacle.body >= bodiesBelow) continue;
    if (!trianglesMeet(obstacle.corners, traversal_.placed.triangle(firstObject + bit / lanes::kLeafTriangles))) {
      continue;
    }
    body = bodiesBelow = obstacle.body;
    found = true;
  }
  return found;
}

/// Pushes the opened pairs that may be within `reach`, the deepest on top.
void KernelQuery::pushWithin(const PairTraversal::Opened& opened, float reach) {
  alignas(32) std::array<float, lanes::kWidth> separation;
  unsigned mask = traversal_.within(opened, reach, separation.data());
  if (mask == 0) return;
  auto deepest = static_cast<unsigned>(__builtin_ctz(mask));
  for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(mask));
    const bool deeper = separation[lane] < separation[deepest];
    stack_.push_back(opened[deeper ? deepest : lane]);
    deepest = deeper ? lane : deepest;
  }
  stack_.push_back(opened[deepest]);
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
    pushWithin(traversal_.open(pair), 0.0F);
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
    if (traversal_.obstacles().lowestBody[pair.obstacle] >= lowest) continue;
    if (traversal_.bothLeaves(pair)) {
      leavesMeet(pair, lowest, lowest);
      continue;
    }
    pushWithin(traversal_.open(pair), 0.0F);
  }
  return lowest < std::numeric_limits<int>::max() ? std::optional<int>(lowest) : std::nullopt;
}

/// Adds the opened pairs that may be within `bound` to the heap.
void KernelQuery::push(const PairTraversal::Opened& opened, float bound) {
  alignas(32) std::array<float, lanes::kWidth> squared;
  traversal_.distances(opened, squared.data());
  for (unsigned mask = opened.mask; mask != 0; mask &= mask - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(mask));
    if (squared[lane] > bound) continue;
    candidates_.push_back({opened[lane], squared[lane]});
    std::push_heap(candidates_.begin(), candidates_.end(), farther);
  }
}

/// Removes the nearest pair from the heap.
KernelQuery::Candidate KernelQuery::pop() {
  std::pop_heap(candidates_.begin(), candidates_.end(), farther);
  const Candidate nearest = candidates_.back();
  candidates_.pop_back();
  return nearest;
}

/// Collects in `triangles_` every pair of triangles that may be the nearest or within `bound` (squared). With estimates
/// the bound decreases meanwhile. Returns the last bound.
float KernelQuery::collect(float bound, bool byEstimates) {
  triangles_.clear();
  candidates_.assign(1, {kRoots, 0.0F});
  while (!candidates_.empty()) {
    const Candidate candidate = pop();
    if (candidate.squared > bound) break;
    if (!traversal_.bothLeaves(candidate.pair)) {
      push(traversal_.open(candidate.pair), bound);
      continue;
    }
    const auto leaves = traversal_.triangleDistances(candidate.pair);
    if (byEstimates) bound = std::min(bound, *std::min_element(leaves.estimate.begin(), leaves.estimate.end()));
    for (std::size_t i = 0; i < leaves.squared.size(); ++i) {
      const float squared = leaves.squared[i];
      if (squared <= bound && squared < kFloatInfinity) triangles_.push_back({leaves[i], squared});
    }
  }
  return bound;
}

/// Improves `best` by the collected pairs, in double precision.
void KernelQuery::decide(Best& best) {
  std::sort(triangles_.begin(), triangles_.end(),
            [](const TriangleCandidate& a, const TriangleCandidate& b) { return a.squared < b.squared; });
  std::array<TrianglePair, 4> pairs;
  for (std::size_t i = 0; i < triangles_.size() && triangles_[i].squared <= widenedBound(best.squared);) {
    std::size_t count = 0;
    for (; count < pairs.size() && i < triangles_.size(); ++i) pairs[count++] = triangles_[i].pair;
    const auto squared = traversal_.exactDistances(std::span(pairs).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      const TrianglePair& pair = pairs[k];
      const bool lower = std::pair(pair.obstacle, pair.object) < std::pair(best.pair.obstacle, best.pair.object);
      if (squared[k] < best.squared || (squared[k] == best.squared && lower)) best = {squared[k], pair};
    }
  }
}

NearestObstacle KernelQuery::nearest(const Pose& X_WB, double enough) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const double scale = geometry_->scale;
  NearestObstacle result;
  result.distance = enough;
  if (!moveTo(X_WB, scale * enough)) return result;
  Best best{scale * enough * (scale * enough), {kNone, kNone}};
  if (recentCount_ > 0) {
    triangles_.clear();
    for (std::size_t i = 0; i < recentCount_; ++i) triangles_.push_back({recent_[i], 0.0F});
    decide(best);
  }
  const float left = collect(widenedBound(best.squared), true);
  decide(best);
  if (widenedBound(best.squared) > left) {
    // Estimates are wrong for slivers, so that the pairs that they excluded are tested again.
    collect(widenedBound(best.squared), false);
    decide(best);
  }
  if (best.pair.obstacle == kNone) return result;
  remember(best.pair);
  const TriangleDistance distance =
      triangleDistance(traversal_.obstacleTriangle(best.pair.obstacle), traversal_.placed.triangle(best.pair.object));
  // The distance of surfaces that do not touch is positive, however small.
  result.distance = std::max(std::sqrt(distance.squared) / scale, std::numeric_limits<double>::min());
  result.body = traversal_.obstacles().triangles[best.pair.obstacle].body;
  result.p_WPo = distance.onA / scale;
  result.p_WPn = distance.onB / scale;
  return result;
}

/// True if two leaves meet, or are within `bound`. Triangles that pierce each other may have distant edges, so that
/// distances alone do not detect their contact.
bool KernelQuery::leavesWithin(const BoxPair& leaves, double bound) {
  unsigned mask = traversal_.within(leaves, widenedBound(bound));
  if (mask == 0) return false;
  const std::uint32_t firstObstacle = traversal_.obstacles().leafOf(leaves.obstacle).first;
  const std::uint32_t firstObject = traversal_.object.leafOf(leaves.object).first;
  triangles_.clear();
  for (; mask != 0; mask &= mask - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(mask));
    triangles_.push_back(
        {{firstObstacle + bit % lanes::kLeafTriangles, firstObject + bit / lanes::kLeafTriangles}, 0.0F});
  }
  Best best{kInfinity, {}};
  decide(best);
  int body = 0;
  if (best.squared > bound * bound) return leavesMeet(leaves, std::numeric_limits<int>::max(), body);
  remember(best.pair);
  return true;
}

/// True if one of the recently near pairs is within `bound`.
bool KernelQuery::recentlyWithin(double bound) {
  if (recentCount_ == 0) return false;
  const auto squared = traversal_.exactDistances(std::span(recent_).first(recentCount_));
  const auto nearest = std::min_element(squared.begin(), squared.end());
  if (*nearest > bound * bound) return false;
  // Lanes beyond the count repeat the last pair.
  remember(recent_[std::min<std::size_t>(static_cast<std::size_t>(nearest - squared.begin()), recentCount_ - 1)]);
  return true;
}

/// Puts a pair at the front of the recently near pairs; the oldest is dropped.
void KernelQuery::remember(const TrianglePair& pair) {
  const auto end = recent_.begin() + static_cast<std::ptrdiff_t>(recentCount_);
  auto at = std::find_if(recent_.begin(), end, [&](const TrianglePair& other) {
    return other.obstacle == pair.obstacle && other.object == pair.object;
  });
  if (at == end)
    at = recentCount_ < recent_.size() ? recent_.begin() + static_cast<std::ptrdiff_t>(recentCount_++) : at - 1;
  *at = pair;
  std::rotate(recent_.begin(), at, at + 1);
}

bool KernelQuery::isWithin(const Pose& X_WB, double metres) {
  const double bound = geometry_->scale * metres;
  if (bound < 0.0 || !moveTo(X_WB, bound)) return false;
  if (recentlyWithin(bound)) return true;
  stack_.assign(1, kRoots);
  while (!stack_.empty()) {
    const BoxPair pair = stack_.back();
    stack_.pop_back();
    if (!traversal_.bothLeaves(pair)) {
      pushWithin(traversal_.open(pair), widenedBound(bound));
    } else if (leavesWithin(pair, bound)) {
      return true;
    }
  }
  return false;
}

std::optional<MotionCheck> KernelQuery::checkMotion(const Pose& from, const Pose& to, double required,
                                                    SeekViolation seek, const StopToken& stop) {
  if (traversal_.obstacles().empty() || geometry_->object->empty())
    return MotionCheck{CertificateStatus::Certified, 1.0, 1.0, 0};
  std::uint64_t tried = 0;
  if (seek == SeekViolation::Any) {
    for (const double t : kTriedFirst) {
      ++tried;
      if (touches(interpolate(from, to, t))) return MotionCheck{CertificateStatus::Violated, 0.0, t, tried};
    }
  }
  MotionSearch search(traversal_, motionStacks_, scaled(from), scaled(to), geometry_->scale * required, seek);
  MotionCheck check = search.run(stop);
  check.configurations += tried;
  return check;
}

}  // namespace glissade
