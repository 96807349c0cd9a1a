#include "engine/fits/feature_snap.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <utility>

namespace glissade {
namespace {

using Directions = std::vector<Vector3>;

/// Sine below which directions are parallel.
constexpr double kParallelFeatures = 1e-6;
/// Distance within which axes meet, metres: the accuracy of placed parts of a product.
constexpr double kMeets = 1e-6;
/// Sine between a plane and a direction below which a motion along the direction hardly changes the distance.
constexpr double kAcross = 0.05;
/// Faces snap within this share of the body's size, axes within the whole size.
constexpr double kNearFaces = 0.25;

/// The directions in which a pair can be apart: orthonormal rows.
Eigen::MatrixX3d rowsOf(const SnapFeature& feature) {
  if (feature.kind == SnapFeature::Kind::Plane) return feature.direction.transpose();
  const Vector3 u = feature.direction.unitOrthogonal();
  Eigen::MatrixX3d rows(2, 3);
  rows << u.transpose(), feature.direction.cross(u).transpose();
  return rows;
}

Eigen::Matrix3Xd columnsOf(const Directions& directions) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(directions.size()));
  for (std::size_t i = 0; i < directions.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = directions[i];
  return columns;
}

/// The directions within those of `columns` in which a pair that meets stays together.
Directions withoutRows(const Eigen::Matrix3Xd& columns, const Eigen::MatrixX3d& rows) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(rows * columns, Eigen::ComputeFullV);
  const Eigen::VectorXd& sizes = parts.singularValues();
  Directions left;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    if (i >= sizes.size() || sizes[i] < kParallelFeatures) left.emplace_back(columns * parts.matrixV().col(i));
  }
  return left;
}

}  // namespace

FeatureSnapper::FeatureSnapper(std::vector<SnapFeature> moving, std::vector<SnapFeature> fixed, double size)
    : moving_(std::move(moving)), fixed_(std::move(fixed)), size_(size) {
  for (std::uint32_t i = 0; i < moving_.size(); ++i) {
    for (std::uint32_t k = 0; k < fixed_.size(); ++k) {
      if (moving_[i].kind != fixed_[k].kind) continue;
      if (moving_[i].direction.cross(fixed_[k].direction).norm() < kParallelFeatures) pairs_.push_back({i, k});
    }
  }
}

Vector3 FeatureSnapper::gapOf(const Pair& pair, const Vector3& shift) const {
  const SnapFeature& fixed = fixed_[pair.fixed];
  const Vector3 apart = fixed.point - moving_[pair.moving].point - shift;
  const Vector3 along = apart.dot(fixed.direction) * fixed.direction;
  return fixed.kind == SnapFeature::Kind::Plane ? along : Vector3(apart - along);
}

bool FeatureSnapper::areNear(const Pair& pair, const Vector3& shift) const {
  const SnapFeature& moving = moving_[pair.moving];
  const double most = (moving.kind == SnapFeature::Kind::Plane ? kNearFaces : 1.0) * size_;
  return moving.box.translated(shift).squaredExteriorDistance(fixed_[pair.fixed].box) <= most * most;
}

bool FeatureSnapper::findStep(const Vector3& shift, const Directions& freedom, double reach, Step& step) const {
  const Eigen::Matrix3Xd columns = columnsOf(freedom);
  bool found = false;
  for (const Pair& pair : pairs_) {
    const Vector3 gap = gapOf(pair, shift);
    if (gap.squaredNorm() > reach * reach) continue;  // no movement is shorter than the gap
    const Eigen::MatrixX3d rows = rowsOf(fixed_[pair.fixed]);
    const Eigen::MatrixXd system = rows * columns;
    if (system.norm() < kAcross) continue;
    const Vector3 by = columns * system.completeOrthogonalDecomposition().solve(rows * gap);
    if (by.norm() > reach || (rows * (gap - by)).norm() > kMeets || !areNear(pair, shift + by)) continue;
    step = {{pair.moving, pair.fixed}, by};
    reach = by.norm();
    found = true;
  }
  return found;
}

FeatureSnap FeatureSnapper::snap(const Vector3& shift, const Directions& freedom, double reach) const {
  FeatureSnap snap{shift, {}};
  Directions left = freedom;
  Step step;
  while (!left.empty() && findStep(snap.shift, left, reach, step)) {
    snap.shift += step.by;
    snap.pairs.push_back(step.pair);
    left = withoutRows(columnsOf(left), rowsOf(fixed_[step.pair.fixed]));
  }
  return snap;
}

}  // namespace glissade
