#include "widgets/instruction/projection.h"

#include <algorithm>

namespace glissade {

Projection::Projection(const Vector3& toEye, const Vector3& up) {
  const Vector3 right = up.cross(toEye).normalized();
  R_VW_ << right.transpose(), toEye.cross(right).transpose(), toEye.transpose();
}

Box3 Projection::boxOf(const TriangleMesh& mesh, const Pose& X_WB) const {
  const Eigen::Matrix3d R_VB = R_VW_ * X_WB.orientation.toRotationMatrix();
  const Vector3 p_V = R_VW_ * X_WB.position;
  Box3 box;
  for (const Vector3& vertex : mesh.vertices) box.extend(Vector3(R_VB * vertex + p_V));
  return box;
}

void Projection::fit(const Box3& box_V, const QRectF& target) {
  constexpr double kLeast = 1e-9;  // metres
  if (box_V.isEmpty()) return;
  const Vector3 sizes = box_V.sizes();
  scale_ = std::min(target.width() / std::max(kLeast, sizes.x()), target.height() / std::max(kLeast, sizes.y()));
  const Vector3 middle = box_V.center();
  origin_ = {target.center().x() - scale_ * middle.x(), target.center().y() + scale_ * middle.y()};
}

Vector3 Projection::project(const Vector3& p_W) const {
  const Vector3 p_V = R_VW_ * p_W;
  return {origin_.x() + scale_ * p_V.x(), origin_.y() - scale_ * p_V.y(), p_V.z()};
}

QPointF Projection::pixel(const Vector3& p_W) const {
  const Vector3 p = project(p_W);
  return {p.x(), p.y()};
}

QRectF Projection::rectOf(const Box3& box_V) const {
  return {QPointF(origin_.x() + scale_ * box_V.min().x(), origin_.y() - scale_ * box_V.max().y()),
          QPointF(origin_.x() + scale_ * box_V.max().x(), origin_.y() - scale_ * box_V.min().y())};
}

}  // namespace glissade
