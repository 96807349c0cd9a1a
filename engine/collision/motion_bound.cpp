#include "engine/collision/motion_bound.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glissade {
namespace {

constexpr std::size_t kCellsAlongAnAxis = 8;

std::size_t cellOf(const Box3& box, const Vector3& p) {
  std::size_t cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double width = box.sizes()[axis];
    const double scaled = width > 0.0 ? (p[axis] - box.min()[axis]) / width * kCellsAlongAnAxis : 0.0;
    cell = cell * kCellsAlongAnAxis + static_cast<std::size_t>(std::clamp(scaled, 0.0, kCellsAlongAnAxis - 1.0));
  }
  return cell;
}

}  // namespace

Velocity::Velocity(const Pose& from, const Pose& to) : translation_W(to.position - from.position) {
  const Quaternion turn = from.orientation.conjugate() * to.orientation;
  const double sine = turn.vec().norm();
  if (sine <= 0.0) return;
  axis_B = turn.vec() / (turn.w() < 0.0 ? -sine : sine);
  rotation = 2.0 * std::atan2(sine, std::abs(turn.w()));
}

MotionBound::MotionBound(const TriangleMesh& object) {
  const Box3 box = boundingBox(object);
  std::array<std::vector<Vector3>, kCellsAlongAnAxis * kCellsAlongAnAxis * kCellsAlongAnAxis> cells;
  for (const Vector3& vertex : welded(object).vertices) cells[cellOf(box, vertex)].push_back(vertex);
  for (std::vector<Vector3>& vertices : cells) {
    if (vertices.empty()) continue;
    Box3 around;
    for (const Vector3& vertex : vertices) around.extend(vertex);
    Cluster cluster{around.center(), 0.0, 0.0, std::move(vertices)};
    for (const Vector3& vertex : cluster.vertices) {
      cluster.radius = std::max(cluster.radius, (vertex - cluster.centre).norm());
      cluster.farthest = std::max(cluster.farthest, vertex.norm());
    }
    clusters_.push_back(std::move(cluster));
  }
  std::sort(clusters_.begin(), clusters_.end(),
            [](const Cluster& a, const Cluster& b) { return a.farthest > b.farthest; });
}

double MotionBound::squaredArm(const Vector3& axis) const {
  double squared = 0.0;
  for (const Cluster& cluster : clusters_) {
    if (cluster.farthest * cluster.farthest <= squared) break;
    const double most = axis.cross(cluster.centre).norm() + cluster.radius;
    if (most * most <= squared) continue;
    for (const Vector3& vertex : cluster.vertices) squared = std::max(squared, axis.cross(vertex).squaredNorm());
  }
  return squared;
}

double MotionBound::operator()(const Pose& from, const Pose& to) const {
  const Velocity velocity(from, to);
  if (velocity.rotation <= 0.0) return velocity.translation_W.norm();
  return velocity.translation_W.norm() + velocity.rotation * std::sqrt(squaredArm(velocity.axis_B));
}

}  // namespace glissade
