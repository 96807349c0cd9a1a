#include "engine/check/hull_clearance.h"

#include <algorithm>
#include <vector>

namespace glissade::check {
namespace {

/// Limit of the iterations; distances that converge shrink by a constant factor in each.
constexpr int kMostShareMoves = 500;

std::vector<Vector3> placedVertices(const TriangleMesh& mesh, const Pose& X_WM) {
  std::vector<Vector3> points;
  for (const Vector3& vertex : mesh.vertices) points.push_back(X_WM * vertex);
  return points;
}

const Vector3& lowest(const std::vector<Vector3>& points, const Vector3& direction) {
  return *std::min_element(points.begin(), points.end(),
                           [&](const Vector3& p, const Vector3& q) { return p.dot(direction) < q.dot(direction); });
}

/// A difference of two vertices, with its weight in the nearest difference found.
struct Share {
  Vector3 difference;
  double share;
};

/// Moves weight from the difference that is farthest along `nearest` to the one that is least far (Mitchell, Demyanov
/// and Malozemov 1974).
void moveShare(std::vector<Share>& shares, const Vector3& to, Vector3& nearest) {
  const auto from = std::max_element(shares.begin(), shares.end(), [&](const Share& p, const Share& q) {
    return p.difference.dot(nearest) < q.difference.dot(nearest);
  });
  const Vector3 way = to - from->difference;
  const double length = way.squaredNorm();
  if (length <= 0.0) return;
  const double part = std::clamp(-nearest.dot(way) / length, 0.0, from->share);
  nearest += part * way;
  from->share -= part;
  if (from->share <= 0.0) shares.erase(from);
  const auto known =
      std::find_if(shares.begin(), shares.end(), [&](const Share& each) { return each.difference == to; });
  if (known != shares.end()) {
    known->share += part;
  } else {
    shares.push_back({to, part});
  }
}

}  // namespace

bool hullsAreClear(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB, double distance) {
  const std::vector<Vector3> ofA = placedVertices(a, X_WA);
  const std::vector<Vector3> ofB = placedVertices(b, X_WB);
  Vector3 nearest = ofA.front() - ofB.front();
  std::vector<Share> shares{{nearest, 1.0}};
  for (int step = 0; step < kMostShareMoves; ++step) {
    const double length = nearest.norm();
    if (length <= distance) return false;
    const Vector3 least = lowest(ofA, nearest) - lowest(ofB, -nearest);
    if (least.dot(nearest) > distance * length) return true;
    moveShare(shares, least, nearest);
  }
  return false;
}

}  // namespace glissade::check
