#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QRectF>

#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// A parallel projection to a picture, as drawings of work instructions use it. The view's frame V: x to the right, y
/// up, z towards the eye.
class Projection {
 public:
  /// Precondition: `up` is not parallel to toEye.
  Projection(const Vector3& toEye, const Vector3& up);

  /// Rows are the axes of V in the world.
  const Eigen::Matrix3d& R_VW() const { return R_VW_; }
  /// The box in V of a mesh at X_WB.
  Box3 boxOf(const TriangleMesh& mesh, const Pose& X_WB) const;
  /// Centres a box in V in a rectangle of the picture, in pixels, as large as possible.
  void fit(const Box3& box_V, const QRectF& target);

  double pixelsPerMetre() const { return scale_; }
  /// The point in the picture. x and y: pixels, y down; z: metres towards the eye.
  Vector3 project(const Vector3& p_W) const;
  QPointF pixel(const Vector3& p_W) const;
  /// The rectangle of the picture that a box in V covers.
  QRectF rectOf(const Box3& box_V) const;

 private:
  Eigen::Matrix3d R_VW_;
  double scale_ = 1.0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  ///< pixels of the origin of V
};

/// A body of a drawing.
struct DrawnBody {
  MeshPtr mesh;
  Pose X_WB;
  QColor fill;
  QColor line;
  bool strong = false;  ///< drawn with thick lines
};

/// The bodies as a drawing on white: light shades, and lines where a body ends, where its surface has a sharp edge, and
/// where a part of it is in front of another. The processor draws it, so that any thread can call this.
QImage lineDrawing(const std::vector<DrawnBody>& bodies, const Projection& projection, const QSize& pixels);

}  // namespace glissade
