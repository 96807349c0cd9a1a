#include "widgets/openxr/text_in_room.h"

namespace glissade {
namespace {

/// Angle of a pixel, radians.
constexpr double kPixel = 0.4e-3 / 0.6;

/// The upright orientation that faces this direction. If that is vertical, x is the room's x.
Quaternion towards(const Vector3& direction) {
  const Vector3 z = direction.normalized();
  Vector3 x = Vector3::UnitY().cross(z);
  x = x.norm() > 1e-6 ? Vector3(x.normalized()) : Vector3::UnitX();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return Quaternion(axes);
}

}  // namespace

ShownPicture textInRoom(const FlatPicturePtr& picture, const Vector3& p_RT, const Vector3& p_RH) {
  const Vector3 toHead = p_RH - p_RT;
  const double distance = toHead.norm();
  if (!picture || distance == 0.0) return {};
  const double pixel = kPixel * distance;
  return {Pose{p_RT, towards(toHead)}, pixel * picture->width, pixel * picture->height, picture};
}

}  // namespace glissade
